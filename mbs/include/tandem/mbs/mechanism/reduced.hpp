// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <memory>
#include <vector>

#include "tandem/mbs/model.hpp"

namespace tandem::mbs {

/// Variables that all others follow, where the gradients of the constraints are those at q: the wanted ones, then the
/// liked ones that are independent of them, then those that move most. Empty if the wanted ones depend on each other.
std::vector<int> independent_variables(const Model& model, const Eigen::VectorXd& q,
                                       const std::vector<int>& wanted, const std::vector<int>& liked);

/// A model by independent coordinates p: q'' = R p'' + s, so that (R^T M R) p'' = R^T (Q - M s) (coordinate partitioning:
/// R. A. Wehage, E. J. Haug, J. Mech. Design 104, 1982). R and s follow from Phi_q R = 0 and Phi_q s = -gamma, with the
/// unit matrix and zeros in the rows of p.
class Reduced {
 public:
  /// `model` must outlive it and stands at its time. q: all coordinates, near where it stands.
  Reduced(const Model& model, std::vector<int> variables, Eigen::VectorXd q);
  ~Reduced();

  const std::vector<int>& variables() const { return variables_; }
  /// All coordinates, as of the last stand_at(): where the next one begins to look.
  const Eigen::VectorXd& q() const { return q_; }
  void begin_at(const Eigen::VectorXd& q) { q_ = q; }
  /// Throws Error(numerical) where the others do not follow from p.
  void stand_at(const Eigen::VectorXd& p);

  /// There, with rates u of p: those of all variables, and p'' of the model's own forces.
  Eigen::VectorXd rates(const Eigen::VectorXd& u);
  Eigen::VectorXd accelerations(const Eigen::VectorXd& u);
  /// R^T b of forces on all variables, R^T M R, and what forces on p accelerate.
  Eigen::VectorXd reduced(const Eigen::VectorXd& b) const { return r_.transpose() * b; }
  const Eigen::MatrixXd& mass() const { return reduced_mass_; }
  Eigen::VectorXd answer(const Eigen::VectorXd& b) const;

 private:
  class Equations;
  const Model& model_;
  std::vector<int> variables_;
  Eigen::VectorXd q_;
  std::unique_ptr<Equations> equations_;
  Eigen::MatrixXd mass_, r_, reduced_mass_;
};

}  // namespace tandem::mbs
