// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <thread>

#include "cli/commands.hpp"
#include "cli/study_file.hpp"
#include "cli/sweep_study.hpp"
#include "cli/validators.hpp"
#include "tandem/error.hpp"

namespace tandem::cli {
namespace {

struct SweepOptions {
  std::string study, where;
  std::filesystem::path output;
  std::vector<std::string> overrides, tables;
  std::uint64_t seed = 0;
  bool resume = false, dry = false;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
};

void sweep(const SweepOptions& options, const Context& context) {
  const auto file = study_path(options.study);
  if (!std::filesystem::exists(file))
    throw Error(ErrorCode::input_output,
                "'" + options.study + "' is no file" +
                    (file == options.study ? "" : ", and there is no " + file.string()));
  sweep_study({file, options.output, options.overrides, options.tables, options.where, options.threads,
               options.resume, options.dry, "", options.seed},
              context);
}

}  // namespace

void add_sweep(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand("sweep", "Run a scenario over columns of values, and write the tables");
  auto options = std::make_shared<SweepOptions>();
  command
      ->add_option("study", options->study,
                   "A study, a TOML file (docs/studies.md), a scenario that has none, or NAME of "
                   "scenarios/NAME/study.toml")
      ->required();
  command->add_option("--set", options->overrides, "Set a value of the scenario, as in run (repeatable)")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all();
  command->add_option("--table", options->tables, "Make this table alone (repeatable; default: all)")
      ->expected(1)
      ->take_all();
  command
      ->add_option("--where", options->where, "Run only the rows for which this expression of columns holds")
      ->type_name("EXPRESSION");
  command->add_option("--seed", options->seed, "Of the values that a study draws: other ones (default: 0)")
      ->check(whole);
  command->add_flag(
      "--dry-run", options->dry,
      "Tell the rows, the references, what is refused and about how long it takes, for which the first "
      "0.1 s of some runs are run; write nothing");
  command
      ->add_option("--output", options->output,
                   "Folder for the tables (default: results/FOLDER, that of the study)")
      ->type_name("DIR");
  command->add_flag("--resume", options->resume,
                    "Keep the rows that are there, if study, scenario and program are the same");
  command->add_option("--threads", options->threads, "Number of threads (default: all cores)")
      ->check(threads);
  command->footer("A scenario is code: the programs and libraries that it names are run with your rights.");
  command->callback([options, &context] { sweep(*options, context); });
}

}  // namespace tandem::cli
