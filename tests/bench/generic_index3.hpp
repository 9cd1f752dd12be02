// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/SparseCholesky>
#include <vector>

#include "tandem/mbs/stepper.hpp"

namespace tandem::bench {

/// What the prepared algebra is measured against: the index-3 formulation of mbs::Index3 (trapezoidal rule,
/// one projection, multipliers from zero) written with Eigen's sparse expressions and its simplicial L D L^T,
/// of which the pattern is analyzed once. The model's terms are the same code.
class GenericIndex3 final : public mbs::Stepper {
 public:
  GenericIndex3(mbs::Model& model, double penalty, double tolerance);
  void start(mbs::State& state) override;
  int step(mbs::State& state, double h, double t_end) override;
  void refresh(mbs::State& state) override;

 private:
  using Sparse = Eigen::SparseMatrix<double>;
  using Vector = Eigen::VectorXd;
  void constraints(const mbs::State& s);
  Sparse tangent(double weight) const { return mass_ + weight * (transposed_ * transposed_.transpose()); }
  double correct(mbs::State& s, double h);
  void project_velocities(mbs::State& s, double weight);
  void project_accelerations(mbs::State& s, double weight);

  mbs::Model& model_;
  double penalty_, tolerance_;
  Sparse mass_, transposed_;  ///< M and Phi_q^T
  std::vector<double> jacobian_;
  Vector phi_, gamma_, force_;
  Eigen::SimplicialLDLT<Sparse> solver_;
};

}  // namespace tandem::bench
