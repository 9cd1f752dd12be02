// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <string>

#include "tandem/coordinator/impulse/force_window.hpp"
#include "tandem/error.hpp"

namespace tandem {

inline void require_of_coupling(bool holds, const std::string& what) {
  if (!holds) throw Error(ErrorCode::invalid_argument, "impulse coupling: " + what);
}

/// Throws Error(invalid_argument) for what no surrogate can go by.
template <class Coupling>
void check_times(const Coupling& of) {
  const auto above_zero = [](double one) { return std::isfinite(one) && one > 0.0; };
  require_of_coupling(above_zero(of.own_step) && above_zero(of.slow_step) && above_zero(of.fast_period),
                      "own steps and the fast period are to be above 0 s");
  require_of_coupling(of.slow_step > of.own_step,
                      "the slow side's own step is not longer than the fast side's");
  require_of_coupling(of.degree >= 1 && of.degree <= 4,
                      "the force is continued by a polynomial of degree 1 to 4");
}

/// Of the fewest steps, as long as a slow step is shorter than 0.65 fast periods.
inline ForceWindow::Kind window_for(double slow_step, double fast_period) {
  return slow_step < 0.65 * fast_period ? ForceWindow::Kind::hat : ForceWindow::Kind::b_spline;
}

}  // namespace tandem
