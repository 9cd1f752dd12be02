// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <thread>

#include "cli/commands.hpp"
#include "cli/study_file.hpp"
#include "cli/sweep_four_bar.hpp"
#include "cli/sweep_mechanisms.hpp"
#include "cli/sweep_study.hpp"
#include "tandem/error.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

struct SweepOptions {
  std::string scene, where;
  fs::path output, mechanisms = "scenarios/mechanisms";
  std::vector<std::string> overrides, tables;
  bool resume = false, only_table = false, dry = false;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
};

}  // namespace

void add_sweep(CLI::App& app, Context& context) {
  auto* command =
      app.add_subcommand("sweep", "Run a scene over its schemes and frequency ratios, and write the table");
  auto options = std::make_shared<SweepOptions>();
  command
      ->add_option("study", options->scene,
                   "A study, a TOML file (docs/studies.md), a scenario that has none, or NAME of "
                   "scenarios/NAME/study.toml; or a scene of "
                   "tandem's own: "
                   "mechanisms (every formulation and integrator on every example); or "
                   "four_bar "
                   "(the N-fold four-bar linkage through its flat position)")
      ->required();
  command
      ->add_option("--set", options->overrides,
                   "Of a study: set a value of its scenario, as in run (repeatable)")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all();
  command
      ->add_option("--table", options->tables, "Of a study: make this table alone (repeatable; default: all)")
      ->expected(1)
      ->take_all();
  command
      ->add_option("--where", options->where,
                   "Of a study: run only the rows for which this expression of columns holds")
      ->type_name("EXPRESSION");
  command->add_flag("--dry-run", options->dry,
                    "Of a study: tell its rows, its references and what is refused, and run nothing");
  command
      ->add_option("--output", options->output,
                   "Folder for the tables (default: results/SCENE; for mechanisms and four_bar results/mbs)")
      ->type_name("DIR");
  command
      ->add_option("--mechanisms", options->mechanisms,
                   "Folder of the example mechanisms (default: scenarios/mechanisms)")
      ->type_name("DIR");
  command->add_flag("--resume", options->resume,
                    "Of a study: keep the rows that are there, if study, scenario and program are the same");
  command->add_flag("--table-only", options->only_table,
                    "Leave out what only the charts need (traces, run times)");
  command->add_option("--threads", options->threads, "Number of threads (default: all cores)")
      ->check(CLI::Range(1U, 1024U));
  command->footer(
      "A scenario is code: the programs and libraries that those of the folders name are run with your "
      "rights.");
  command->callback([options, &context] {
    const std::string& scene = options->scene;
    if (fs::exists(study_path(scene)))
      return sweep_study({study_path(scene), options->output, options->overrides, options->tables,
                          options->where, options->threads, options->resume, options->dry},
                         context);
    if (options->output.empty())
      options->output = fs::path("results") / (scene == "mechanisms" || scene == "four_bar" ? "mbs" : scene);
    if (scene == "mechanisms")
      sweep_mechanisms({options->mechanisms, options->output, options->threads, options->only_table},
                       context);
    else if (scene == "four_bar")
      sweep_four_bar(options->output, options->threads, context);
    else
      throw Error(ErrorCode::input_output,
                  "'" + scene + "' is no file, and there is no " + study_path(scene).string());
  });
}

}  // namespace tandem::cli
