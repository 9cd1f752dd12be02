// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "tandem/charts/gnuplot.hpp"

namespace tandem::charts {

/// A row of what `tandem sweep four_bar` writes of the index-3 formulation with nothing else set.
struct LinkageError {
  double loops, step, tolerance;  ///< [s], [m]
  double x_error;                 ///< after 20 s [m]; NaN if it did not get there
};

/// Throws Error for a file that is no such table.
std::vector<LinkageError> read_linkage_errors(const std::filesystem::path& file);

/// The error over the number of loops, and over the step. What did not get to the end is a cross at the top.
/// The grey line is 2e-3 m. Throws Error if there are no rows.
Picture linkage_errors_chart(const std::vector<LinkageError>& errors,
                             const std::vector<std::string>& caption);

}  // namespace tandem::charts
