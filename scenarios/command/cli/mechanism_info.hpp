// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>

#include "tandem/mbs/mechanism/description.hpp"
#include "tandem/text/document.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::cli {

/// True for a TOML file with the tables of a mechanism.
bool is_mechanism(const std::filesystem::path& file);

/// [s]: of the table [run].
double start_of(const text::Document& mechanism);

/// Those that the file gives no value. A line that tells which, or "".
std::string take_unknown_inputs_as_zero(mbs::Description& description);

/// Prints variables, constraints, degrees of freedom, redundant and contradictory equations and the filling
/// of the tangent, then checks its run. overrides: "KEY=VALUE".
void print_mechanism(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                     const Builtins& builtins);

}  // namespace tandem::cli
