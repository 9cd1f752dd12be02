// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Dense>

namespace tandem::stability {

/// The part of a map on which it can be undone: what is multiplied by 0 once, or again and again (an output that waits for its
/// time), is not in it. Its eigenvalues are those of the map that are not 0; rounding would make of m of these that hang
/// together eigenvalues of the m-th root of itself.
struct Remembered {
  Eigen::MatrixXd map;
  Eigen::MatrixXd basis;  ///< basis * v is an eigenvector of the whole map where v is one of `map`
  Eigen::MatrixXd back;   ///< likewise w * back of its left ones
};

/// By a QR decomposition with pivots of the map, balanced, and again of what it leaves. What is below 1e-9 of the rest counts as 0.
Remembered remembered(const Eigen::MatrixXd& map);

}  // namespace tandem::stability
