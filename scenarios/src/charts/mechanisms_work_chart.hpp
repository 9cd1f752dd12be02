// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "tandem/charts/gnuplot.hpp"

namespace tandem::charts {

/// A row of work.csv of `tandem sweep mechanisms`.
struct FormulationWork {
  std::string mechanism, formulation, integrator;
  double error, seconds;  ///< [m or rad], [s]; NaN if the run failed
};

/// Throws Error for a file that is no such table.
std::vector<FormulationWork> read_formulation_work(const std::filesystem::path& file);

/// Error against processor time, a panel for each mechanism; a formulation by its colour, an integrator by
/// its marker. Throws Error if there are no rows.
Picture mechanisms_work_chart(const std::vector<FormulationWork>& work,
                              const std::vector<std::string>& caption);

}  // namespace tandem::charts
