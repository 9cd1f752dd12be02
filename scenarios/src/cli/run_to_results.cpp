// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/run_to_results.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>

#include "cli/interrupt.hpp"
#include "cli/kept_folder.hpp"
#include "cli/looking.hpp"
#include "cli/run_progress.hpp"
#include "cli/run_reference.hpp"
#include "cli/say.hpp"
#include "mechanisms/source.hpp"
#include "output/files.hpp"
#include "scenario/checkpoint.hpp"
#include "scenario/results.hpp"
#include "tandem/library_file.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;
using scenario::Assembly;
using scenario::RunEnd;
using scenario::Scenario;

Scenario scenario_of(const RunOptions& options, const Context& context) {
  return with_matrices(scenario::read(options.file, options.overrides), options.matrices, context.builtins);
}

fs::path folder_of(const RunOptions& options) {
  return options.output.empty() ? fs::path("results") / options.file.stem() : options.output;
}

/// How far the run has come [s]. One that samples stands still from one instant to the next, so those that
/// integrate themselves tell, if there are any.
double slowest_time(const Coordinator& run) {
  constexpr double none = std::numeric_limits<double>::infinity();
  double integrating = none, sampled = none;
  for (int i = 0; i < run.topology().size(); ++i) {
    double& slowest = run.topology().info(i).abilities.sampled ? sampled : integrating;
    slowest = std::min(slowest, run.time(i));
  }
  return integrating < none ? integrating : sampled;
}

/// One run of a scenario, from its file to its results.
class Run {
 public:
  Run(const RunOptions& options, const Context& context)
      : options_(options),
        context_(context),
        scenario_(scenario_of(options, context)),
        folder_(folder_of(options)),
        kept_(options.dry ? nullptr : std::make_unique<KeptFolder>(folder_)),
        kept_of_matrices_(kept_of_matrices()),
        assembly_(scenario_, context.builtins, options.profile, options.threads),
        recorder_(assembly_.recorder(folder_, [this] { begin(); })),
        checkpoint_(scenario_, context.builtins, assembly_, *recorder_),
        began_at_(scenario_.start) {
    if (options.checkpoint_every || !options.resume.empty()) check_checkpoints();
    if (scenario_.reference && !options.no_reference) reference_.emplace(scenario_, *recorder_);
  }

  void dry() {
    output::check_folder(folder_);
    assembly_.initialize();
    tell_notes();
    if (!context_.quiet) say("{}: ok; it would write to {}\n", scenario_.file.string(), folder_.string());
  }

  void make() {
    LibraryCall::return_from_faults();
    start();
    output::remove_part(checkpoint_file());  // of a run that was killed
    tell_coordination();
    simulate();
    close();
    if (reference_ && end_.status == "ok") reference_->compare(folder_);
    write();
    tell_notes();
    tell();
  }

 private:
  void start() try {
    if (options_.resume.empty()) assembly_.coordinator().observe(recorder_.get());
    assembly_.initialize();
    if (!options_.resume.empty()) resume();
  } catch (const std::exception& error) {
    fail("failed", sentence_of(error));
    if (has_begun_) write_results();
    throw;
  }

  /// Nobody is to find the status of an earlier run beside the rows of this one, however it ends.
  void begin() {
    const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
    RunEnd running{"running", fmt::format("process {}, since {:%Y-%m-%dT%H:%M:%SZ}", getpid(), now)};
    scenario::write_json(folder_ / "results.json",
                         scenario::results_of(scenario_, assembly_, *recorder_, running));
    if (fs::is_regular_file(folder_ / "machine.json")) fs::remove(folder_ / "machine.json");
    has_begun_ = true;
  }

  std::unique_ptr<KeptFolder> kept_of_matrices() const {
    const auto& folder = options_.matrices.folder;
    return folder && kept_ && !kept_->keeps(*folder) ? std::make_unique<KeptFolder>(*folder) : nullptr;
  }

  void check_checkpoints() const {
    if (options_.checkpoint_every && !(*options_.checkpoint_every > 0.0))
      throw Error(
          ErrorCode::invalid_argument,
          fmt::format("--checkpoint-every is {} s; allowed is a number above 0", *options_.checkpoint_every));
    text::located([&](const std::string& sentence) { return scenario_.place_named_in(sentence); },
                  [&] { assembly_.coordinator().require_serializable(); });
  }

  void resume() {
    checkpoint_.resume(options_.resume);
    assembly_.coordinator().observe(recorder_.get());
    began_at_ = slowest_time(assembly_.coordinator());
    checkpoints_passed_ = times_passed(began_at_);
    if (!context_.quiet) say("resumed at t = {} s\n", began_at_);
  }

  fs::path checkpoint_file() const { return folder_ / "checkpoint"; }

  void simulate() {
    const InterruptGuard guard;
    Coordinator& run = assembly_.coordinator();
    RunProgress progress(began_at_, scenario_.stop, !context_.quiet);
    try {
      for (double flush_at = 1.0; run.round() && !InterruptGuard::interrupted();) {
        recorder_->between_rounds();
        if (options_.checkpoint_every) write_if_due(slowest_time(run));
        if (!progress.due()) continue;
        progress.show(slowest_time(run));
        if (const double now = progress.seconds(); now >= flush_at) recorder_->flush(), flush_at = now + 1.0;
      }
      if (InterruptGuard::interrupted()) interrupted(slowest_time(run));
    } catch (const Diverged& error) {
      fail("diverged", error.what());
    } catch (const std::exception& error) {
      fail("failed", scenario::with_address(scenario_, context_.builtins, sentence_of(error)));
    }
    end_.seconds = progress.seconds();
    if (end_.status == "ok") progress.end(slowest_time(run));
  }

  /// Times of checkpoints up to t.
  double times_passed(double t) const {
    return options_.checkpoint_every ? std::floor((t - scenario_.start) / *options_.checkpoint_every) : 0.0;
  }

  void write_if_due(double t) {
    const double passed = times_passed(t);
    if (passed <= checkpoints_passed_) return;
    checkpoint_.write(checkpoint_file());
    checkpoints_passed_ = passed;
  }

  void interrupted(double t) {
    const std::string when = fmt::format("interrupted at t = {} s", t);
    fail("interrupted", when);
    if (!options_.checkpoint_every) return;
    checkpoint_.write(checkpoint_file());
    fail("interrupted", fmt::format("--resume {} goes on from there", checkpoint_file().string()));
  }

  void fail(const std::string& status, const std::string& message) {
    if (end_.status == "ok") end_.status = status;
    end_.message += (end_.message.empty() ? "" : "; ") + message;
  }

  void close() {
    try {
      recorder_->close();
    } catch (const Error& error) {
      fail("failed", error.what());
    }
  }

  /// The status comes last: what it tells of is on the disk then.
  void write() {
    const double simulated = slowest_time(assembly_.coordinator()) - began_at_;
    try {
      scenario::write_json(folder_ / "machine.json",
                           scenario::machine_figures(assembly_, end_, options_.profile, simulated));
      for (const fs::path& file : recorder_->files()) output::sync(file);
    } catch (const Error& error) {
      fail("failed", error.what());
    }
    write_results();
  }

  void write_results() {
    auto results = scenario::results_of(scenario_, assembly_, *recorder_, end_);
    if (reference_ && end_.status == "ok") results["reference"] = reference_->figures();
    try {
      scenario::write_json(folder_ / "results.json", results);
    } catch (const Error& error) {
      fail("failed", error.what());
    }
  }

  void tell_coordination() const {
    const Coordinator& run = assembly_.coordinator();
    spdlog::debug("{}: {} s to {} s, schedule {}, start {} ({} passes)", scenario_.file.string(),
                  scenario_.start, scenario_.stop, Schedule::name(run.schedule().kind()), name(run.start()),
                  run.start_passes());
    for (const int i : run.schedule().order())
      spdlog::debug("subsystem '{}': first own step {} s", run.topology().name(i), run.own_step(i));
    for (const auto& file : recorder_->files()) spdlog::debug("recording to {}", file.string());
  }

  void tell_notes() const {
    for (const std::string& note : assembly_.notes()) spdlog::info("note: {}", note);
    for (const std::string& note : recorder_->notes()) spdlog::info("note: {}", note);
    if (has_begun_ && options_.checkpoint_every && !fs::exists(checkpoint_file()))
      spdlog::info("note: no checkpoint was written: the run ended before the first, {} s after its start",
                   *options_.checkpoint_every);
  }

  void tell() const {
    if (end_.status != "ok")
      throw RunFailed(fmt::format("{}: {}; what was recorded until then is kept in {}",
                                  scenario_.file.string(), end_.message, folder_.string()));
    if (!context_.quiet) {
      for (const fs::path& file : recorder_->files()) say("wrote {}\n", file.string());
      say("wrote {}\nwrote {}\n", (folder_ / "results.json").string(), (folder_ / "machine.json").string());
      if (reference_) say("{}", reference_->report());
    }
    if (reference_) reference_->refuse_outside();
  }

  const RunOptions& options_;
  const Context& context_;
  Scenario scenario_;
  fs::path folder_;
  std::unique_ptr<KeptFolder> kept_, kept_of_matrices_;  ///< null in a dry run
  Assembly assembly_;
  std::unique_ptr<Recorder> recorder_;
  scenario::Checkpoint checkpoint_;
  bool has_begun_ = false;           ///< files of an earlier run are replaced or cut
  double began_at_;                  ///< [s]: where the stepping began
  double checkpoints_passed_ = 0.0;  ///< times of checkpoints that lie behind
  std::optional<RunReference> reference_;
  RunEnd end_;
};

}  // namespace

void run_to_results(const RunOptions& options, const Context& context) { Run(options, context).make(); }

void run_dry(const RunOptions& options, const Context& context) {
  const Scenario scenario = scenario_of(options, context);
  Context looking = context;
  looking.builtins = mechanisms::without_matrices(context.builtins);
  if (options.run_programs || !scenario::names_code(scenario, looking.builtins))
    return Run(options, looking).dry();
  output::check_folder(folder_of(options));
  check_in_part(scenario, looking.builtins, !options.no_reference);
}

}  // namespace tandem::cli
