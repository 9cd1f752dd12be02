// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "tandem/mbs/mechanism/mechanism.hpp"

namespace tandem::mbs {

/// Evaluates the outputs that a mechanism's description names.
class Outputs {
 public:
  /// `mechanism` must outlive it.
  explicit Outputs(const Mechanism& mechanism);

  int size() const { return static_cast<int>(outputs_.size()); }
  const std::string& name(int output) const { return outputs_[static_cast<std::size_t>(output)].name; }
  /// "m", "rad/s", "N" and so on.
  std::string unit(int output) const;
  /// Whether it depends on an input at the same instant: on a drive's all do; on a force's, accelerations and
  /// reactions.
  bool depends(int output, int input) const;

  /// y: one for each output. State: complete, at the time of the mechanism's last at_time(). Positions,
  /// velocities and accelerations are those of the state; reactions are computed from its multipliers.
  void evaluate(const State& state, double* y);
  /// Derivatives by time that a state has: two of positions, one of velocities, none of the others.
  int derivatives(int output) const;
  /// Those of one order, 1 or 2; 0 where there are none.
  void derivatives(const State& state, int order, double* dy) const;

 private:
  /// A coordinate that does not move, and what of M and of Phi_q belongs to it.
  struct Support {
    int coordinate = -1;
    std::vector<std::pair<int, double>> masses = {};          ///< by coordinate
    std::vector<std::pair<int, std::size_t>> gradients = {};  ///< by equation: entry of the Jacobian
  };
  Support support(const Output& output) const;
  void prepare_reactions(const State& state);
  double value(int output, const State& state) const;
  double reaction(const Support& support, const State& state) const;

  const Mechanism& mechanism_;
  const std::vector<Output>& outputs_;
  bool reactions_ = false;
  std::vector<Support> supports_;  ///< by output; of reactions
  Eigen::VectorXd phi_, force_;
  std::vector<double> jacobian_;
};

}  // namespace tandem::mbs
