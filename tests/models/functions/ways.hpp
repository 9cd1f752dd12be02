// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

namespace tandem::functions {

/// The double pendulum let go level, by the index-3 formulation with alpha = 1e8, dense LAPACK and a Newton
/// tolerance of 1e-5 m: a motion of `steps` steps of `step` [s].
struct Motion {
  double step;
  int steps;
};

/// What came of it, in one way to evaluate the functions.
struct Outcome {
  long iterations = 0;
  double seconds = 0.0;  ///< without the start of Octave
  Eigen::VectorXd q, v;  ///< at the end
};

/// A way to evaluate mass matrix, constraints, Jacobian and forces.
struct Way {
  std::string name;  ///< cpp, pipe, library or mex
  std::function<Outcome(const Motion&)> run;
};

/// The ways that this build has: without Octave's headers there is no mex. Running one throws Error if Octave
/// is absent.
std::vector<Way> ways();

}  // namespace tandem::functions
