// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

namespace tandem::identification {

/// Where in an own step a model looks at its inputs, as parts of the step: a polynomial of degree 4 is known by these.
constexpr std::array<double, 5> places = {0.0, 0.25, 0.5, 0.75, 1.0};

/// What a subsystem makes of one own step. With x what it differs by from where it stands at the start, and u what its
/// inputs differ by from those that it started with:
///   x+ = A x + sum over j of B_j u(t + places[j] h) + e,   y = C x + D u + y0,
/// and x = S u at the start. Of a sampled subsystem a step is what it makes of one instant, where it looks at its inputs
/// once, at places[0]; x and u of y are those at the instant, before that step.
struct LinearModel {
  double step = 0.0;           ///< h, or the period [s]
  double offset = 0.0;         ///< of a sampled one: the first instant after the start [s]
  Eigen::VectorXd before;      ///< and its values until then
  Eigen::VectorXd inputs;      ///< that it started with
  std::vector<int> values;     ///< which values of a sample row it gives, in the order of C's rows
  Eigen::MatrixXd a, c, d, s;  ///< A, C, D, S
  Eigen::MatrixXd b;           ///< columns by input, then by place
  Eigen::VectorXd e, y0;
  /// What it leaves of the responses that it was found from: the largest difference of a value, by the largest that the
  /// value is in that response.
  double residual = 0.0;
  bool linear = false;  ///< half a change of an input makes half the response, to 1e-10

  Eigen::Index order() const { return a.rows(); }
};

}  // namespace tandem::identification
