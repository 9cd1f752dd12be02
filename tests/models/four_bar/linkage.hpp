// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace tandem::four_bar {

/// How the cranks stand at the start.
enum class Start { upright, hanging };

/// The N-fold four-bar linkage with so many loops, as the text of a mechanism file: rods of 1 m and 1 kg,
/// couplers level, ground pivots 1 m apart, the moving points at 1 m/s in x at the start. Hanging, it swings
/// by less than 18 degrees and never comes near the flat position.
std::string text(int loops, Start start = Start::upright);

/// The crank's angle from upright [rad] and its rate [rad/s] at a time: as all cranks stay parallel,
/// theta'' = c sin theta with c = (3/2) g (3 L + 1)/(4 L + 1), from Lagrange's equation with kinetic energy
/// 1/2 (4 L + 1)/3 theta'^2 and potential energy g (3 L + 1)/2 cos theta. Integrated by the classical
/// Runge-Kutta method in steps of 1e-4 s, which errs by less than 1e-11 rad in 20 s.
struct Crank {
  double angle, rate;
};
Crank exact(int loops, double time);
/// The same at 0, interval, 2 interval, ... [s]: `count` intervals, so one more crank.
std::vector<Crank> exact_path(int loops, Start start, double interval, int count);

}  // namespace tandem::four_bar
