// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tandem/mbs/sparse/solver_choice.hpp"

namespace tandem::bench {

/// Measured times of the solvers, for the rule of `auto`.
class SolverFit {
 public:
  void add(const std::string& kind, const std::string& solver, const mbs::EliminationCost& cost,
           double seconds) {
    times_[{kind, solver}].push_back({cost, seconds});
  }
  /// Of each kind and solver the four coefficients of the model [ns] (mbs/src/solvers/auto.cpp), none below
  /// zero, with the least sum of squared relative errors (C. L. Lawson, R. J. Hanson, Solving Least Squares
  /// Problems, 1974, ch. 23), and the root mean square of these.
  void print() const;

 private:
  struct Time {
    mbs::EliminationCost cost;
    double seconds;
  };
  std::map<std::pair<std::string, std::string>, std::vector<Time>> times_;
};

}  // namespace tandem::bench
