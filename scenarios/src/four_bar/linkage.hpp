// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace tandem::four_bar {

/// The N-fold four-bar linkage with so many loops, as the text of a mechanism file: rods of 1 m and 1 kg,
/// cranks upright at the start, couplers level, ground pivots 1 m apart, the moving points at 1 m/s in x.
std::string text(int loops);

/// The crank's angle from upright [rad] and its rate [rad/s] at a time: as all cranks stay parallel,
/// theta'' = c sin theta with c = (3/2) g (3 L + 1)/(4 L + 1), from Lagrange's equation with kinetic energy
/// 1/2 (4 L + 1)/3 theta'^2 and potential energy g (3 L + 1)/2 cos theta. Integrated by the classical
/// Runge-Kutta method in steps of 1e-4 s, which errs by less than 1e-11 rad in 20 s.
struct Crank {
  double angle, rate;
};
Crank exact(int loops, double time);

}  // namespace tandem::four_bar
