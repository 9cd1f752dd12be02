// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "cli/looking.hpp"
#include "cli/say.hpp"
#include "ladder/ladder_run.hpp"
#include "tandem/scenario/assembly.hpp"
#include "tandem/scenario/comparison.hpp"
#include "tandem/scenario/run.hpp"
#include "tandem/sources/mechanism.hpp"

namespace tandem::cli {
namespace {

struct ValidateOptions {
  std::string file;
  std::vector<std::string> overrides;
  bool run_programs = false;
};

/// Its rungs are opened: where that would run code, only if that is wanted.
void check_ladder(const scenario::Scenario& scenario, const ValidateOptions& options,
                  const Builtins& builtins) {
  const auto of_rungs = scenario::overrides_of_rungs(options.overrides);
  if (options.run_programs || !scenario::names_code_in_rungs(scenario, of_rungs, builtins))
    scenario::Ladder(scenario, of_rungs, builtins);
  else
    say("note: rungs of the ladder were not opened, as they are code; say --run-programs\n");
}

void validate(const ValidateOptions& options, const Context& context) {
  const Builtins builtins = without_matrices(context.builtins);
  const auto scenario =
      as_it_is_stated(scenario::read(options.file, options.overrides), builtins, options.run_programs);
  if (!options.run_programs && scenario::names_code(scenario, builtins))
    return check_in_part(scenario, builtins, true);
  scenario::Assembly assembly(scenario, builtins);
  const auto recorder = assembly.recorder(".");
  const auto indicators = assembly.indicators();
  if (scenario.reference) scenario::reference_of(scenario);
  assembly.initialize();
  if (scenario.ladder) check_ladder(scenario, options, builtins);
  say("{}: ok\n", options.file);
  for (const std::string& note : assembly.notes()) say("note: {}\n", note);
  if (!scenario::by_impulse(scenario)) say("tandem advise {} tells which scheme to take\n", options.file);
}

}  // namespace

void add_validate(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand("validate", "Check a scenario up to its first step");
  auto options = std::make_shared<ValidateOptions>();
  command->add_option("scenario", options->file, "The scenario, a TOML file or a system of SSP")
      ->required()
      ->type_name("FILE");
  command->add_option("--set", options->overrides, "Set a value of the file, as in run (repeatable)")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all();
  add_run_programs(*command, options->run_programs);
  command->footer(
      "Without --run-programs a scenario with sources that are code is checked in part: what was left out is "
      "named.\n"
      "Which scheme to take, tandem advise tells.\n"
      "Exit status: 0, also then; or 2 with the file, the line, the value found and what is allowed.");
  command->callback([options, &context] { validate(*options, context); });
}

}  // namespace tandem::cli
