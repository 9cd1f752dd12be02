// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "tandem/mbs/mechanism/initial.hpp"

namespace tandem::mbs {

/// Phi and Phi_q where a model stands, and which of its coordinates may move.
class Linearized {
 public:
  /// Both must outlive it. known: coordinates that stay.
  Linearized(Model& model, const std::vector<Known::Value>& known);

  void evaluate(const Eigen::VectorXd& q) { model_.constraints(q.data(), phi.data(), values_.data()); }
  /// Phi_q v.
  Eigen::VectorXd rate(const Eigen::VectorXd& v) const;
  /// The shortest step of the coordinates that may move with Phi_q d = -error, as nearly as there is one;
  /// zero where no gradient has a part along them.
  Eigen::VectorXd step(const Eigen::VectorXd& error) const;
  /// Moves those coordinates by up to `most`, each by another part of it, the same in every run.
  void push(Eigen::VectorXd& q, double most) const;
  double unit() const { return model_.structure().unit(); }  ///< [m]
  int variables() const { return model_.structure().variables; }

  Eigen::VectorXd phi;
  double limit = 0.0;  ///< of |Phi|: assemble() takes it from the size of what is drawn

 private:
  Model& model_;
  std::vector<double> values_;
  std::vector<bool> stays_;  ///< by variable
};

/// Newton's method on the positions, the known ones brought to their values; false if the constraints don't
/// close: then q is where they come nearest, and at.phi tells how near.
bool assemble(Linearized& at, Eigen::VectorXd& q, const std::vector<Known::Value>& known);

/// The largest magnitude; not a number if one is none.
double largest(const Eigen::VectorXd& x);

/// Beyond this an error is one, and not rounding: `values` are the positions or velocities that it is of.
inline double tolerable(double largest_value) { return 1e-9 * (largest_value > 0.0 ? largest_value : 1.0); }

}  // namespace tandem::mbs
