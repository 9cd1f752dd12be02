// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/scenario/run.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

#include "pace.hpp"
#include "results.hpp"
#include "run_checkpoints.hpp"
#include "run_estimate.hpp"
#include "run_indicators.hpp"
#include "run_reference.hpp"
#include "tandem/coordinator/observers.hpp"
#include "tandem/error.hpp"
#include "tandem/output/files.hpp"
#include "tandem/output/lock.hpp"
#include "tandem/scenario/about.hpp"

namespace tandem::scenario {
namespace {

namespace fs = std::filesystem;

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

}  // namespace

class Run::Stages {
 public:
  Stages(const Scenario& scenario, const Builtins& builtins, RunSettings settings, bool writes)
      : scenario_(scenario), builtins_(builtins), settings_(std::move(settings)) {
    if (writes) kept_.emplace(settings_.folder, [this](const std::string& what) { notes_.push_back(what); });
    assembly_.emplace(scenario_, builtins_, settings_.profile, settings_.threads);
    go_home();
    recorder_ = assembly_->recorder(settings_.folder, [this] { begin(); });
    observers_.add(*recorder_);
    if ((indicators_ = assembly_->indicators())) observers_.add(*indicators_);
    if (scenario_.indicators == Indication::estimate) expect();
    checkpoints_.emplace(
        Checkpoint(scenario_, builtins_, *assembly_, *recorder_, {indicators_.get(), estimate_.get()}),
        settings_.folder, settings_.checkpoint_every, scenario_.start);
    if (checkpoints_->wanted() || !settings_.resume.empty())
      located([this](const std::string& sentence) { return scenario_.place_named_in(sentence); },
              [this] { run().require_serializable(); });
    if (scenario_.reference && settings_.compares) reference_.emplace(scenario_, *recorder_);
  }

  void check() {
    output::check_folder(settings_.folder);
    assembly_->initialize();
  }

  void start() try {
    const bool anew = settings_.resume.empty();
    if (anew) run().observe(&observers_);
    assembly_->initialize();
    if (!anew) checkpoints_->resume(settings_.resume), run().observe(&observers_);
    began_at_ = anew ? scenario_.start : time();
    checkpoints_->begin_at(began_at_);
    output::remove_part(checkpoints_->file());  // of a run that was killed
  } catch (const std::exception& error) {
    fail("failed", sentence_of(error));
    if (has_begun_) write_results();
    throw;
  }

  RunEnd finish(const RunListener& listener) {
    simulate(listener);
    attempt([&] { go_home(), recorder_->close(); });
    if (indicators_) {
      attempt([&] {
        write_indicators(settings_.folder / "indicators.csv", *indicators_, estimate_.get(), time());
      });
      end_.indicators = told_by(*indicators_);
      if (estimate_) end_.estimate = estimate_->told();
    }
    if (reference_ && end_.status == "ok")
      attempt([&] {
        reference_->compare(settings_.folder);
        end_.report = reference_->report();
        end_.outside = reference_->outside();
      });
    attempt([&] { write_machine_figures(); });
    write_results();
    return end_;
  }

  const Assembly& assembly() const { return *assembly_; }
  double time() const { return slowest_time(assembly_->coordinator()); }

  std::vector<fs::path> files() const {
    std::vector<fs::path> all = recorder_->files();
    if (indicators_) all.push_back(settings_.folder / "indicators.csv");
    all.push_back(settings_.folder / "results.json");
    all.push_back(settings_.folder / "machine.json");
    return all;
  }

  std::vector<std::string> notes() const {
    std::vector<std::string> all = notes_;
    for (const auto& some : {assembly_->notes(), recorder_->notes()})
      all.insert(all.end(), some.begin(), some.end());
    if (const std::string note = checkpoints_->note(); has_begun_ && !note.empty()) all.push_back(note);
    return all;
  }

 private:
  Coordinator& run() { return assembly_->coordinator(); }

  void expect() {
    if (!settings_.expectation) settings_.expectation = {.why_not = "nobody said what is expected"};
    const auto& [table, why_not, seconds] = *settings_.expectation;
    if (!table) return void(end_.estimate = "none; " + why_not);
    estimate_ = std::make_unique<Estimate>(assembly_->topology(), *scenario_.judge, *table, *indicators_);
    observers_.add(*estimate_);
  }

  /// Other files of rows that an earlier run left there, by another clock or in another format.
  std::vector<fs::path> rows_of_before() const {
    std::vector<fs::path> all;
    const auto own = recorder_->files();
    for (const std::string& name : files_of(settings_.folder)) {
      const fs::path file = settings_.folder / name;
      const auto& reference = scenario_.reference;
      const bool is_reference =
          reference && fs::weakly_canonical(reference->file) == fs::weakly_canonical(file);
      if (fs::is_regular_file(fs::symlink_status(file)) && std::ranges::find(own, file) == own.end() &&
          !is_reference)
        all.push_back(file);
    }
    return all;
  }

  /// Before any other file of the folder is opened. What was made of earlier results goes with them.
  void begin() {
    go_home();
    const auto files_before = rows_of_before();
    const bool had_results = fs::is_regular_file(settings_.folder / "results.json");
    const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
    RunEnd running{"running", fmt::format("process {}, since {:%Y-%m-%dT%H:%M:%SZ}", getpid(), now)};
    write_json(settings_.folder / "results.json", results_of(scenario_, *assembly_, *recorder_, running));
    std::vector<const char*> old = {"machine.json", "indicators.csv"};
    if (had_results) old.insert(old.end(), {"view.html", "plot.svg"});
    for (const char* name : old)
      if (fs::is_regular_file(settings_.folder / name)) fs::remove(settings_.folder / name);
    for (const fs::path& file : files_before) fs::remove(file);
    has_begun_ = true;
  }

  void simulate(const RunListener& listener) {
    Pace pace;
    try {
      bool going = true;
      for (double flush_at = 1.0; going && run().round(); going = !listener.going || listener.going()) {
        recorder_->between_rounds();
        if (checkpoints_->wanted()) write_checkpoint_if_due();
        if (!pace.due()) continue;
        if (listener.come) listener.come(time());
        if (pace.seconds_read() >= flush_at) recorder_->flush(), flush_at = pace.seconds_read() + 1.0;
      }
      if (!going) interrupted();
    } catch (const Diverged& error) {
      fail("diverged", error.what());
    } catch (const std::exception& error) {
      fail("failed", with_address(scenario_, builtins_, sentence_of(error)));
    }
    end_.seconds = pace.seconds();
  }

  void interrupted() {
    fail("interrupted", fmt::format("interrupted at t = {} s", time()));
    if (!checkpoints_->wanted()) return;
    go_home();
    checkpoints_->write();
    fail("interrupted", fmt::format("--resume {} goes on from there", checkpoints_->file().string()));
  }

  void fail(const std::string& status, const std::string& message) {
    if (end_.status == "ok") end_.status = status;
    end_.message += (end_.message.empty() ? "" : "; ") + message;
  }

  template <class Work>
  void attempt(const Work& work) {
    try {
      work();
    } catch (const std::exception& error) {
      fail("failed", sentence_of(error));
    }
  }

  void write_checkpoint_if_due() {
    if (!checkpoints_->is_due(time())) return;
    go_home();
    checkpoints_->write_at(time());
  }

  /// A library may have gone elsewhere, where paths mean other files.
  void go_home() const {
    std::error_code none;
    fs::current_path(home_, none);
  }

  /// The status comes last: what it tells of is on the disk then.
  void write_machine_figures() {
    write_json(settings_.folder / "machine.json",
               machine_figures(*assembly_, end_, settings_, time() - began_at_));
    for (const fs::path& file : recorder_->files()) output::sync(file);
  }

  void write_results() {
    auto results = results_of(scenario_, *assembly_, *recorder_, end_);
    if (indicators_) add_figures(*indicators_, estimate_.get(), results);
    if (scenario_.indicators == Indication::estimate && !estimate_)
      results["indicators"]["no_estimate"] = settings_.expectation->why_not;
    if (reference_ && end_.status == "ok") results["reference"] = reference_->figures();
    attempt([&] { write_json(settings_.folder / "results.json", results); });
  }

  const Scenario& scenario_;
  const Builtins& builtins_;
  RunSettings settings_;
  std::error_code no_home_;  ///< the folder is gone
  const fs::path home_ = fs::current_path(no_home_);
  std::vector<std::string> notes_;
  std::optional<output::FolderLock> kept_;  ///< none where nothing is written
  std::optional<Assembly> assembly_;
  std::unique_ptr<Recorder> recorder_;
  std::unique_ptr<Indicators> indicators_;  ///< null: none are wanted
  std::unique_ptr<Estimate> estimate_;      ///< null: there is none
  Observers observers_;
  std::optional<RunCheckpoints> checkpoints_;
  std::optional<RunReference> reference_;
  bool has_begun_ = false;  ///< files of an earlier run are replaced or cut
  double began_at_ = 0.0;   ///< [s]: where the stepping began
  RunEnd end_;
};

Run::Run(const Scenario& scenario, const Builtins& builtins, RunSettings settings)
    : stages_(std::make_unique<Stages>(scenario, builtins, std::move(settings), true)) {}
Run::~Run() = default;

void Run::start() { stages_->start(); }
RunEnd Run::finish(const RunListener& listener) { return stages_->finish(listener); }
const Assembly& Run::assembly() const { return stages_->assembly(); }
double Run::time() const { return stages_->time(); }
std::vector<fs::path> Run::files() const { return stages_->files(); }
std::vector<std::string> Run::notes() const { return stages_->notes(); }

std::vector<std::string> Run::check(const Scenario& scenario, const Builtins& builtins,
                                    RunSettings settings) {
  Stages stages(scenario, builtins, std::move(settings), false);
  stages.check();
  return stages.notes();
}

RunEnd run(const Scenario& scenario, const Builtins& builtins, RunSettings settings,
           const RunListener& listener) {
  Run one(scenario, builtins, std::move(settings));
  one.start();
  return one.finish(listener);
}

}  // namespace tandem::scenario
