// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "tandem/charts/gnuplot.hpp"

namespace tandem::charts {

/// A row of schemes.csv of `tandem sweep split_pendulum`.
struct SplitPendulumScheme {
  std::string formulation, fast, schedule, to_lower, to_upper, lag;
  double carried_mass, lower_mass, ratio;  ///< [kg], [kg], of the steps
  double error;                            ///< largest [m]; NaN if it was unstable
};

/// Throws Error for a file that is no such table.
std::vector<SplitPendulumScheme> read_split_pendulum_schemes(const std::filesystem::path& file);

/// Largest error by `null_space` with the lower rod of 0.1 kg fast, ten of its steps in one: a column of
/// panels for each schedule but staggered (which has matched hold alone, and is lost), a row without and with
/// a quarter of the lower rod's mass carried; displacements side by side, a force by its colour and marker,
/// crosses where a scheme is unstable or lost. Throws Error if there is no such row.
Picture split_pendulum_chart(const std::vector<SplitPendulumScheme>& schemes,
                             const std::vector<std::string>& caption);

}  // namespace tandem::charts
