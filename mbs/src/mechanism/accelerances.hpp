// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <vector>

#include "constrained_accelerations.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"

namespace tandem::mbs {

/// By how much inputs accelerate coordinates, of the outputs that ask for it: the accelerations of the generalised forces of
/// an input of 1 alone.
class Accelerances {
 public:
  /// `mechanism` must outlive it.
  Accelerances(const Mechanism& mechanism, const std::vector<Output>& outputs);

  /// Where a state stands: the values, or their rates by a central difference along the motion. Throws Error(numerical) if
  /// they can't be told. One factorization each, of the rates two; they allocate.
  void find(const State& s);
  void find_rates(const State& s);
  /// Of an output of that kind, by its number.
  double value(int output) const { return values_[places_[static_cast<std::size_t>(output)]]; }
  double rate(int output) const { return rates_[places_[static_cast<std::size_t>(output)]]; }

 private:
  struct One {
    int coordinate, input;
  };
  void find(const Eigen::VectorXd& q, std::vector<double>& to);

  const Mechanism& mechanism_;
  ConstrainedAccelerations solver_;
  std::vector<One> all_;
  std::vector<std::size_t> places_;  ///< by output; of that kind
  std::vector<double> values_, rates_, after_;
};

}  // namespace tandem::mbs
