// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/residuals.hpp"

namespace tandem::mbs {

class Accelerances;
class Measurements;

/// Evaluates the outputs that a mechanism's description names, or others.
class Outputs {
 public:
  /// `mechanism` must outlive it.
  explicit Outputs(const Mechanism& mechanism);
  Outputs(const Mechanism& mechanism, std::vector<Output> outputs);
  ~Outputs();

  int size() const { return static_cast<int>(outputs_.size()); }
  const std::string& name(int output) const { return outputs_[static_cast<std::size_t>(output)].name; }
  /// "m", "rad/s", "N" and so on.
  std::string unit(int output) const;
  /// Whether it depends on an input at the same instant. On a force's: accelerations and reactions of what
  /// the mass matrix and the constraints connect with the place where it acts, and residuals of
  /// accelerations. On a drive's: all of what they connect with its coordinate, and energies and residuals.
  bool depends(int output, int input) const;

  /// From this state on energies drift. Complete, as below.
  void start(const State& state);

  /// y: one for each output. State: complete, at the time of the mechanism's last at_time(). Positions,
  /// velocities and accelerations are those of the state; reactions are computed from its multipliers.
  void evaluate(const State& state, double* y);
  /// Derivatives by time that a state has: two of positions, one of velocities, of accelerances and of elements'
  /// quantities that don't follow an input at once, none of the others.
  int derivatives(int output) const;
  /// Those of one order, 1 or 2; 0 where there are none.
  void derivatives(const State& state, int order, double* dy);

 private:
  /// A coordinate that does not move, or a body's, and what of M and of Phi_q belongs to it there.
  struct Support {
    int coordinate = -1;
    std::vector<std::pair<int, double>> masses = {};          ///< by coordinate
    std::vector<std::pair<int, std::size_t>> gradients = {};  ///< by equation: entry of the Jacobian
    std::size_t equations = 0;                                ///< of the mechanism
    bool of_body = false;
    double weight = 0.0;  ///< of a body
    bool borne(const std::vector<int>& parts, int part) const;
  };
  Support support(const Output& output) const;
  Support body_support(const Output& output) const;
  void prepare(const State& state);
  double value(int output, const State& state) const;
  double reaction(const Support& support, const State& state) const;
  bool follows(int output, int part) const;
  bool connected(int output, int part) const;
  const ForceElement& element(const Output& output) const;
  double angle(const Output& output, const State& state) const;

  const Mechanism& mechanism_;
  std::vector<Output> outputs_;
  std::vector<int> parts_;                      ///< by coordinate, a number that connected ones share
  std::vector<std::vector<int>> force_groups_;  ///< coordinates that a force connects
  std::unique_ptr<Measurements> measurements_;
  std::unique_ptr<Accelerances> accelerances_;
  bool reactions_ = false, has_residuals_ = false;
  std::vector<Support> supports_;  ///< by output; of reactions
  Eigen::VectorXd phi_, force_;
  std::vector<double> jacobian_;
  ConstraintResiduals find_residuals_;
  Residuals residuals_;
  double energy_at_start_ = 0.0;
};

}  // namespace tandem::mbs
