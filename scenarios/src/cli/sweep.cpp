// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "two_mass/sweep.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "cli/commands.hpp"
#include "cli/conditions.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress.hpp"
#include "tandem/error.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

constexpr int work_repetitions = 5;

struct Options {
  std::string scene;
  fs::path output;
  bool pairs = false, resume = false, only_table = false;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
};

void write_text(const fs::path& file, const std::string& text) {
  std::ofstream out(file);
  out << text;
  out.close();
  if (!out) throw Error(ErrorCode::input_output, "file '" + file.string() + "' can't be written");
}

std::vector<two_mass::Case> cases_of(const Options& options) {
  std::vector<two_mass::Case> cases;
  for (const double ratio : two_mass::sweep_ratios())
    for (const auto& scheme : two_mass::sweep_schemes(options.pairs)) cases.push_back({scheme, ratio});
  return cases;
}

/// What a sweep that is resumed must agree on with the one before.
nlohmann::ordered_json settings_of() {
  return {{"scene", "two_mass"},
          {"cycles", two_mass::Case{}.cycles},
          {"steps_per_cycle", two_mass::Case{}.steps_per_cycle},
          {"version", TANDEM_VERSION},
          {"commit", source_commit()}};
}

/// The table to go on from: empty, or with --resume the one in the folder if it was made with the same
/// settings.
two_mass::SweepTable begin_table(const Options& options) {
  const fs::path table = options.output / "sweep.csv", settings = options.output / "sweep.json";
  two_mass::SweepTable rows;
  if (options.resume && fs::exists(table) && fs::exists(settings)) {
    std::ifstream in(settings);
    const bool changed =
        source_commit().ends_with("-dirty");  // whatever the table was made with, it was other code
    if (!changed && nlohmann::ordered_json::parse(in, nullptr, false) == settings_of())
      rows = two_mass::SweepTable::read(table);
    else
      spdlog::info("The sweep in {} was made by other code or with other settings; it is made anew.",
                   options.output.string());
  }
  write_text(settings, settings_of().dump(2) + "\n");
  return rows;
}

void write_timings(const fs::path& file, const std::map<std::string, double>& seconds) {
  std::string text = "schedule,to_fast,to_slow,frequency_ratio,seconds\n";
  for (const auto& [key, value] : seconds) text += fmt::format("{},{:.6g}\n", key, value);
  write_text(file, text);
}

void run_table(const Options& options, const Context& context) {
  const auto cases = cases_of(options);
  auto table = begin_table(options);
  const fs::path file = options.output / "sweep.csv";
  Progress progress("sweep", cases.size(), !context.quiet);
  const auto seconds = two_mass::run_sweep(cases, options.threads, table, [&](std::size_t done) {
    progress.update(done);
    return !InterruptGuard::interrupted();
  });
  table.write(file, cases);
  if (!seconds.empty()) write_timings(options.output / "sweep_timings.csv", seconds);
  if (table.size() < cases.size())
    throw RunFailed(fmt::format("interrupted; {} of {} rows are kept in {}, --resume goes on from there",
                                table.size(), cases.size(), file.string()));
}

/// Speed against accuracy: one case at a time, so that the times mean something.
void run_work(const Options& options, const Context& context) {
  const auto cases = two_mass::work_cases();
  const fs::path file = options.output / "work.csv";
  if (options.resume && fs::exists(file) && fs::exists(options.output / "conditions.json")) return;
  std::string text = two_mass::work_header() + "\n";
  Progress progress("work ", cases.size(), !context.quiet);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    progress.update(i);
    if (InterruptGuard::interrupted())
      throw RunFailed("interrupted; the table is kept, --resume makes what is missing");
    text += two_mass::work_row(cases[i], work_repetitions) + "\n";
  }
  progress.update(cases.size());
  write_text(file, text);
}

void sweep(const Options& options, const Context& context) {
  std::error_code failed;
  fs::create_directories(options.output, failed);
  if (failed)
    throw Error(ErrorCode::input_output,
                "folder '" + options.output.string() + "' can't be made: " + failed.message());
  const InterruptGuard guard;
  run_table(options, context);
  if (!options.only_table) {
    two_mass::write_traces(options.output / "traces.csv");
    run_work(options, context);
    write_text(options.output / "conditions.json", conditions(work_repetitions).dump(2) + "\n");
  }
  if (!context.quiet) fmt::print("wrote {}\n", (options.output / "sweep.csv").string());
}

}  // namespace

void add_sweep(CLI::App& app, Context& context) {
  auto* command =
      app.add_subcommand("sweep", "Run a scene over its schemes and frequency ratios, and write the table");
  auto options = std::make_shared<Options>();
  command->add_option("scene", options->scene, "The scene: two_mass")
      ->required()
      ->check(CLI::IsMember({"two_mass"}));
  command
      ->add_option("--output", options->output,
                   "Folder for sweep.csv and what belongs to it (default: results/SCENE)")
      ->type_name("DIR");
  command->add_flag("--pairs", options->pairs, "All 25 pairs of degrees, not only equal ones");
  command->add_flag("--resume", options->resume,
                    "Keep the rows that are there from a sweep that was stopped");
  command->add_flag("--table-only", options->only_table,
                    "Leave out what only the charts need (traces, run times)");
  command->add_option("--threads", options->threads, "Number of threads (default: all cores)")
      ->check(CLI::Range(1U, 1024U));
  command->callback([options, &context] {
    if (options->output.empty()) options->output = fs::path("results") / options->scene;
    sweep(*options, context);
  });
}

}  // namespace tandem::cli
