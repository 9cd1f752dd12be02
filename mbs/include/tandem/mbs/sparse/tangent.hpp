// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "tandem/mbs/model.hpp"
#include "tandem/mbs/sparse/condensed_states.hpp"
#include "tandem/mbs/sparse/linear_solver.hpp"
#include "tandem/mbs/sparse/rank_update.hpp"

namespace tandem::mbs {

/// Values of a model's matrices where it stands, on the patterns of its structure.
struct ModelMatrices {
  explicit ModelMatrices(const Structure& s)
      : jacobian(static_cast<std::size_t>(s.jacobian_values())),
        stiffness(static_cast<std::size_t>(s.stiffness_values())),
        damping(stiffness.size()) {}
  std::vector<double> jacobian;            ///< Phi_q^T
  std::vector<double> stiffness, damping;  ///< K = -dQ/dq, C = -dQ/dq'
};

/// M + damping C + stiffness K + penalty Phi_q^T Phi_q, factorized.
struct TangentFactors {
  double damping, stiffness, penalty;
};

/// That matrix on the union of all patterns, with its solver: prepared once, then assembled where the solver
/// wants it and factorized, without a look-up.
class Tangent {
 public:
  Tangent(const Structure& structure, std::unique_ptr<LinearSolver> solver);

  void assemble(const ModelMatrices& at, const TangentFactors& factors);
  /// -1, or the variable at which the matrix is singular.
  int factorize() { return solver_->factorize(values_.data()); }
  /// The matrix as assembled, or its factors where the solver factorizes in place.
  const std::vector<double>& values() const { return values_; }
  /// These, and what the solver goes by besides; and back, factorized. Error(invalid_argument) for those of
  /// another.
  void remember(std::vector<double>& to) const;
  void recall(std::span<const double> memory);
  /// b becomes T^-1 b.
  void solve(double* b);

  /// The union of the patterns, both triangles.
  const Pattern& pattern() const { return pattern_; }

 private:
  std::unique_ptr<LinearSolver> solver_;
  Pattern pattern_;
  Layout layout_;
  RankUpdate update_;
  CondensedStates states_;
  std::vector<double> mass_, base_, values_;  ///< by position of the solver's layout; what states keep
  std::vector<int> from_, to_;                ///< positions of K and C that the layout has, and theirs in it
};

}  // namespace tandem::mbs
