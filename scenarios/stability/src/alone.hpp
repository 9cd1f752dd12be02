// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "trial.hpp"

namespace tandem::stability {

/// One subsystem of a trial alone, about its states and inputs at the start. What it is changed by may be
/// large if it is linear; else it is small.
class Alone {
 public:
  Alone(const Trial& trial, int instance, bool linear);

  Eigen::Index states() const { return x_.size(); }
  Eigen::Index inputs() const { return u_.size(); }
  Eigen::Index outputs() const { return subsystem_.info().output_size(); }
  bool lands() const { return subsystem_.info().abilities.lands; }
  double step() const { return step_; }  ///< [s]
  /// That it gives by itself (Subsystem::linearized).
  std::optional<Linearized> equations();

  /// Columns [A B; C' D'] of a step of this length: states and outputs at its end by states at its begin and
  /// constant inputs.
  Eigen::MatrixXd response(double length);
  /// The column of an input that is (time/length)^2 beside its start.
  Eigen::VectorXd bent(Eigen::Index input, double length);

 private:
  double change(double about) const;
  std::vector<Segment> constant(const Eigen::VectorXd& change) const;
  Samples start(const Eigen::VectorXd& u);
  Eigen::VectorXd after(const Eigen::VectorXd& change, double length, const std::vector<Segment>& pieces);

  Subsystem& subsystem_;
  double begin_, step_;
  bool linear_;
  Eigen::VectorXd x_, u_;  ///< about which it is looked at
  std::vector<double> row_;
};

}  // namespace tandem::stability
