// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>

namespace tandem::cli {

/// True for a TOML file that has a dimension, as only mechanisms do.
bool is_mechanism(const std::filesystem::path& file);

/// Prints variables, constraints, degrees of freedom, redundant equations and the filling of the tangent.
void print_mechanism(const std::filesystem::path& file);

}  // namespace tandem::cli
