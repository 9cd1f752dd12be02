// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/run_to_results.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <csignal>
#include <memory>

#include "cli/adviser.hpp"
#include "cli/interrupt.hpp"
#include "cli/kept_folder.hpp"
#include "cli/looking.hpp"
#include "cli/run_progress.hpp"
#include "cli/say.hpp"
#include "tandem/advice/expected.hpp"
#include "tandem/library_file.hpp"
#include "tandem/output/files.hpp"
#include "tandem/scenario/checkpoint.hpp"
#include "tandem/scenario/run.hpp"
#include "tandem/scenario/taken.hpp"
#include "tandem/sources/mechanism.hpp"
#include "tandem/stability/fast_period.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;
using scenario::RunEnd;
using scenario::Scenario;

fs::path folder_of(const RunOptions& options) {
  return options.output.empty() ? fs::path("results") / options.file.stem() : options.output;
}

/// --estimate is a setting of the scenario like others.
std::vector<std::string> overrides_of(const RunOptions& options) {
  auto all = options.overrides;
  if (options.estimate) all.emplace_back("record.indicators=estimate");
  return all;
}

/// What it took stays.
Scenario with_taken_before(const Scenario& scenario, const fs::path& checkpoint) {
  const auto taken = scenario::Checkpoint::taken(checkpoint);
  const auto key = [](const std::string& text) { return text.substr(0, text.find('=')); };
  for (const std::string& one : scenario.overrides)
    for (const std::string& other : taken)
      if (key(one) == key(other))
        throw Error(ErrorCode::invalid_argument,
                    fmt::format("--set {}: the run of checkpoint '{}' took {}; allowed is to leave it so",
                                one, checkpoint.string(), other));
  return scenario::with_taken(scenario, taken);
}

/// What it leaves to be taken is taken; of a run that is resumed it was.
Scenario scenario_of(const RunOptions& options, const Context& context) {
  Scenario scenario = scenario::read(options.file, overrides_of(options));
  if (scenario.chooses)
    scenario = options.resume.empty() ? advised(scenario, folder_of(options) / "advice", context)
                                      : with_taken_before(scenario, options.resume);
  scenario = stability::with_fast_period(std::move(scenario), without_matrices(context.builtins));
  return with_matrices(std::move(scenario), options.matrices, context.builtins);
}

scenario::RunSettings settings_of(const RunOptions& options) {
  return {folder_of(options), options.resume,  options.checkpoint_every,
          options.threads,    options.profile, !options.no_reference};
}

/// With what models say, where that is wanted.
scenario::RunSettings settings_of(const RunOptions& options, const Scenario& scenario,
                                  const Context& context) {
  auto settings = settings_of(options);
  if (scenario.indicators != scenario::Indication::estimate) return settings;
  const InterruptGuard guard;
  settings.expectation = advice::expected(scenario, without_matrices(context.builtins),
                                          [] { return !InterruptGuard::interrupted(); });
  if (InterruptGuard::interrupted()) throw RunFailed("interrupted before the run began");
  if (!context.quiet) say("estimate: models and their run took {:.3g} s\n", settings.expectation->seconds);
  return settings;
}

/// The folder of matrices, where it is not that of the results.
std::unique_ptr<KeptFolder> kept_of_matrices(const RunOptions& options) {
  const auto& folder = options.matrices.folder;
  if (!folder || fs::weakly_canonical(*folder) == fs::weakly_canonical(folder_of(options))) return nullptr;
  return std::make_unique<KeptFolder>(*folder);
}

void tell_coordination(const Scenario& scenario, const scenario::Run& one) {
  const Coordinator& run = one.assembly().coordinator();
  spdlog::debug("{}: {} s to {} s, schedule {}, start {} ({} passes)", scenario.file.string(), scenario.start,
                scenario.stop, Schedule::name(run.schedule().kind()), name(run.start()), run.start_passes());
  for (const int i : run.schedule().order())
    spdlog::debug("subsystem '{}': first own step {} s", run.topology().name(i), run.own_step(i));
  for (const fs::path& file : one.files()) spdlog::debug("recording to {}", file.string());
}

RunEnd finish(scenario::Run& run, const Scenario& scenario, double began_at, bool quiet) {
  const InterruptGuard guard;
  RunProgress progress(began_at, scenario.stop, !quiet);
  const RunEnd end =
      run.finish({[] { return !InterruptGuard::interrupted(); }, [&](double t) { progress.show(t); }});
  if (end.status == "ok") progress.end(run.time(), end.seconds);
  return end;
}

void tell_notes(const std::vector<std::string>& notes) {
  for (const std::string& note : notes) spdlog::info("note: {}", note);
}

void tell(const Scenario& scenario, const scenario::Run& run, const RunEnd& end, bool quiet) {
  const fs::path results = run.files().back().parent_path();
  if (end.status != "ok")
    throw RunFailed(fmt::format("{}: {}; what was recorded until then is kept in {}", scenario.file.string(),
                                end.message, results.string()));
  if (!quiet) {
    for (const fs::path& file : run.files()) say("wrote {}\n", file.string());
    say("{}", end.report);
    if (!end.indicators.empty()) say("indicators: {}\n", end.indicators);
    if (!end.estimate.empty()) say("estimate: {}\n", end.estimate);
  }
  if (!end.outside.empty())
    throw RunFailed(fmt::format("{}: the run came to its end, but not within its reference: {}",
                                scenario.reference->place.text(), fmt::join(end.outside, "; ")));
}

}  // namespace

void run_to_results(const RunOptions& options, const Context& context) {
  LibraryCall::return_from_faults();
  std::signal(SIGPIPE, [](int) {});  // a library's; who reads what is told may be gone, too
  const Scenario scenario = scenario_of(options, context);
  const auto kept = kept_of_matrices(options);
  scenario::Run run(scenario, context.builtins, settings_of(options, scenario, context));
  run.start();
  const bool resumed = !options.resume.empty();
  if (resumed && !context.quiet) say("resumed at t = {} s\n", run.time());
  tell_coordination(scenario, run);
  const RunEnd end = finish(run, scenario, resumed ? run.time() : scenario.start, context.quiet);
  tell_notes(run.notes());
  tell(scenario, run, end, context.quiet);
}

void run_dry(const RunOptions& options, const Context& context) {
  const Builtins builtins = without_matrices(context.builtins);
  const Scenario scenario = with_matrices(
      as_it_is_stated(scenario::read(options.file, overrides_of(options)), builtins, options.run_programs),
      options.matrices, context.builtins);
  const fs::path folder = folder_of(options);
  if (options.run_programs || !scenario::names_code(scenario, builtins)) {
    tell_notes(scenario::Run::check(scenario, builtins, settings_of(options)));
    if (!context.quiet) say("{}: ok; it would write to {}\n", scenario.file.string(), folder.string());
  } else {
    output::check_folder(folder);
    check_in_part(scenario, builtins, !options.no_reference);
  }
}

}  // namespace tandem::cli
