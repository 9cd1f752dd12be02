// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <utility>
#include <vector>

#include "tandem/mbs/mechanism/elements.hpp"

namespace tandem::mbs {

/// Forces of one kind, evaluated in one loop. Arrays of forces and of coordinates have an entry for each
/// coordinate, fixed ones included.
class ForceSet {
 public:
  virtual ~ForceSet() = default;
  /// Adds them.
  virtual void add(const double* q, const double* v, double* force) const = 0;
  /// Entries of K and C, (row, column) in the order in which add_derivatives() writes.
  virtual std::vector<std::pair<int, int>> entries() const { return {}; }
  /// Adds K = -dQ/dq and C = -dQ/dq'.
  virtual void add_derivatives(const double*, const double*, double*, double*) const {}
  virtual double potential(const double*) const { return 0.0; }  ///< [J]

  /// For each of the entries its position in the arrays of K and C.
  void place(std::vector<int> to) { to_ = std::move(to); }

 protected:
  std::vector<int> to_;
};

/// k1 x + k2 x^2 + ... + c1 v + c2 v^2 + ...
class SpringLaw {
 public:
  explicit SpringLaw(const Spring& s) : free_(s.free), stiffness_(s.stiffness), damping_(s.damping) {}
  struct Pull {
    double force, by_x, by_v;
  };
  /// x: the coordinate [m or rad], v: its rate.
  Pull at(double x, double v) const {
    Pull pull{0.0, 0.0, 0.0};
    add(stiffness_, x - free_, pull.force, pull.by_x);
    add(damping_, v, pull.force, pull.by_v);
    return pull;
  }
  double potential(double x) const {
    double sum = 0.0;
    for (std::size_t k = stiffness_.size(); k-- > 0;)
      sum = (sum + stiffness_[k] / static_cast<double>(k + 2)) * (x - free_);
    return sum * (x - free_);
  }

 private:
  /// Adds the sum of c_k x^(k+1) and its derivative, by Horner's rule.
  static void add(const std::vector<double>& c, double x, double& value, double& slope) {
    double p = 0.0, dp = 0.0;
    for (std::size_t k = c.size(); k-- > 0;) dp = dp * x + p + c[k], p = (p + c[k]) * x;
    value += p, slope += dp;
  }
  double free_;
  std::vector<double> stiffness_, damping_;
};

}  // namespace tandem::mbs
