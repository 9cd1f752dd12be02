// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <vector>

namespace tandem::identification {

/// Responses of one linear system to several things: each is y(1), y(2), .. in columns.
using Responses = std::vector<Eigen::MatrixXd>;

/// y(k) = C A^(k - 1) x1 of each response.
struct Realisation {
  Eigen::MatrixXd a, c;
  Eigen::MatrixXd x1;  ///< a column for each response
  double residual;     ///< the largest part of a value in a response that it leaves
};

/// The largest difference of a value in a response, by the largest that it is there. What is never more than rounding in
/// that response does not count.
/// - besides: a column for each response, what its values follow at once. They are as large at least.
double residual(const Realisation& of, const Responses& responses, const Eigen::MatrixXd& besides);

/// A step of it can be cut: it is a motion in continuous time, which has no eigenvalue of a step at 0 or below.
bool can_be_cut(const Eigen::MatrixXd& a);

/// The smallest system whose residual is at most 1.5 times the smallest, or 1e-11, of up to most_states states.
/// Precondition: all responses are as long, at least 4, and none is 0.
Realisation realise(const Responses& responses);

}  // namespace tandem::identification
