// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "cli/commands.hpp"
#include "tandem/scenario/parts.hpp"

namespace tandem::cli {

// What `validate`, `info` and `run --dry-run` share: they look at a scenario that may be a stranger's.

/// A scenario that chooses (coordination.scheme = "auto"), with usual values for what it leaves out; it is said. One that lacks
/// its fast period, with it, if that takes no code or run_programs.
scenario::Scenario as_it_is_stated(scenario::Scenario scenario, const Builtins& builtins, bool run_programs);

/// The option by which they open sources that are code.
CLI::Option* add_run_programs(CLI::App& command, bool& run_programs);

/// Checks what can be without that code, with the reference if that is wanted, and prints notes and
/// in_part().
void check_in_part(const scenario::Scenario& scenario, const Builtins& builtins, bool reference);

/// "FILE: checked in part", what was left out and how to go on; empty if nothing was.
std::string in_part(const scenario::Scenario& scenario, const scenario::Parts& parts);

}  // namespace tandem::cli
