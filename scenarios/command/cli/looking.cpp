// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/looking.hpp"

#include <fmt/format.h>

#include "cli/say.hpp"
#include "tandem/scenario/run.hpp"
#include "tandem/scenario/taken.hpp"
#include "tandem/stability/fast_period.hpp"

namespace tandem::cli {

scenario::Scenario as_it_is_stated(scenario::Scenario scenario, const Builtins& builtins, bool run_programs) {
  if (!scenario.chooses)
    return run_programs || !scenario::names_code(scenario, builtins)
               ? stability::with_fast_period(std::move(scenario), builtins)
               : scenario;
  say("note: coordination.scheme is auto: what is left out is taken when it runs, and has its usual value "
      "here\n");
  return scenario::with_usual(std::move(scenario));
}

CLI::Option* add_run_programs(CLI::App& command, bool& run_programs) {
  return command.add_flag("--run-programs", run_programs,
                          "Also open the scenario's sources that are code (command, spawn:, lib:, "
                          "three_functions:, functions:, fmu:), which runs that code with your rights");
}

void check_in_part(const scenario::Scenario& scenario, const Builtins& builtins, bool reference) {
  const scenario::Parts parts(scenario, builtins, scenario::Code::leave_out);
  if (reference && scenario.reference) scenario::reference_of(scenario);
  parts.check_each();
  say("{}", in_part(scenario, parts));
  for (const std::string& note : parts.notes()) say("note: {}\n", note);
}

std::string in_part(const scenario::Scenario& scenario, const scenario::Parts& parts) {
  if (parts.left_out().empty()) return "";
  std::string text = scenario.file.string() + ": checked in part\n";
  for (const std::string& sentence : parts.left_out()) text += sentence + '\n';
  return text + "Say --run-programs to open these too: that runs their code, with your rights.\n";
}

}  // namespace tandem::cli
