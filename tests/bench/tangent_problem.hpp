// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "tandem/mbs/sparse/linear_solver.hpp"

namespace tandem::bench {

/// Matrices of one pattern as a simulation meets them, each a little different from the one before.
struct TangentProblem {
  mbs::Pattern pattern;
  std::vector<std::vector<double>> values;  ///< by position of the pattern
};

/// Where artificial non-zeros stand: near the diagonal, as in a chain whose bodies see more of their
/// neighbours, or anywhere.
enum class Placement { near, anywhere };

struct TangentRequest {
  mbs::MatrixKind kind;
  Placement placement;
  int variables;  ///< about so many rows
  int entries;    ///< in a row, on average; 6: no artificial ones, as the linkage has 7 itself
};

/// Of the N-fold four-bar linkage in its first position, with artificial non-zeros in M.
///   positive definite: M + alpha Phi_q^T Phi_q;
///   symmetric: [M Phi_q^T; Phi_q 0];
///   unsymmetric: the first, with a part that is skew.
TangentProblem tangent_problem(const TangentRequest& request);

}  // namespace tandem::bench
