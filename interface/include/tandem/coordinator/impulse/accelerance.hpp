// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>
#include <vector>

#include "tandem/bytes.hpp"

namespace tandem {

/// By how much forces on the links of a slow side accelerate its displacements: A = J M^-1 J^T, which changes as that
/// side moves. From one node to the next it is A_n + A'_n s, s [s] since the node; its mean over the step is that of the
/// cubic through both ends with their rates.
class Accelerance {
 public:
  Accelerance() = default;
  /// Matrices of p rows, by rows; the rate is per second.
  Accelerance(std::vector<double> a, std::vector<double> rate) : a_(std::move(a)), rate_(std::move(rate)) {}

  /// What p forces accelerate, s after the node.
  void react(std::span<const double> forces, double s, std::span<double> accelerations) const {
    for (std::size_t i = 0, e = 0; i < forces.size(); ++i) {
      accelerations[i] = 0.0;
      for (std::size_t k = 0; k < forces.size(); ++k, ++e)
        accelerations[i] += (a_[e] + rate_[e] * s) * forces[k];
    }
  }
  /// What they accelerate in the mean of the step to `next`, so long [s].
  void react_to(const Accelerance& next, double length, std::span<const double> forces,
                std::span<double> accelerations) const {
    for (std::size_t i = 0, e = 0; i < forces.size(); ++i) {
      accelerations[i] = 0.0;
      for (std::size_t k = 0; k < forces.size(); ++k, ++e)
        accelerations[i] +=
            (0.5 * (a_[e] + next.a_[e]) + length / 12.0 * (rate_[e] - next.rate_[e])) * forces[k];
    }
  }

  std::span<double> values() { return a_; }
  std::span<double> rates() { return rate_; }
  std::span<const double> values() const { return a_; }
  std::span<const double> rates() const { return rate_; }

  void write(ByteWriter& to) const { to.put_doubles(a_), to.put_doubles(rate_); }
  void read(ByteReader& from) {
    for (double& one : a_) one = from.take<double>();
    for (double& one : rate_) one = from.take<double>();
  }

 private:
  std::vector<double> a_, rate_;
};

}  // namespace tandem
