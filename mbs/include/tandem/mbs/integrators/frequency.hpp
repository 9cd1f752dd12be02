// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>

#include "tandem/mbs/integrators/integrator.hpp"

namespace tandem::mbs {

/// The modulus of the largest eigenvalue of a linear map that overwrites its argument, by 50 power
/// iterations. z: of its size, for its arguments.
template <class Map>
double spectral_radius(Eigen::VectorXd& z, const Map& map) {
  for (int i = 0; i < z.size(); ++i) z[i] = std::cos(i);  // some of every direction
  double radius = 0.0;
  for (int k = 0; k < 50 && z.norm() > 0.0; ++k) {
    z /= z.norm();
    map(z);
    radius = z.norm();
  }
  return radius;
}

/// The highest frequency [rad/s] of a problem where it stands: the square root of the spectral radius of
/// df/dy, with central differences. Directions that grow count with their modulus.
double highest_frequency(SecondOrder& problem, const Motion& motion);

/// The largest omega h with which Newmark's method (gamma = 1/2) is stable: its amplification has the trace
/// 2 - x/(1 + beta x), x = (omega h)^2, and determinant 1, so x (1/4 - beta) <= 1, whatever the damping
/// (T. Hughes, The Finite Element Method, 1987, sect. 9.1). Infinite for beta = 1/4.
double newmark_limit(double beta);

/// So many steps apart the highest frequency is looked at.
constexpr int steps_between_checks = 50;

/// Throws Error(numerical) for a step beyond that, which names limit and found; `owner` begins the sentence.
void refuse_unstable(const char* owner, double beta, double frequency, double t, double h);

/// What Newmark's formulas multiply errors of v and h a by in a step, where y = 0 is held at both ends (a
/// constraint): the larger root of z^2 - (2 - 1/beta) z + 1 in modulus. 1 for beta = 1/4, 9.9 for 1/12.
double newmark_growth(double beta);

}  // namespace tandem::mbs
