// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Dense>
#include <unsupported/Eigen/MatrixFunctions>

#include "relay_models.hpp"

namespace tandem::test {

/// (x, v, z, r) at rising times, by the exponential of the matrix from one switching to the next.
class ExactRelay {
 public:
  explicit ExactRelay(const RelaySystem& s, double t_start = 0.0) : s_(s), t_(t_start) {
    all_ << 0, 1, 0, 0, -s.w * s.w, -2 * s.d * s.w, s.gain_y, s.gain_r + s.gain_y * s.jump, 1, 0, -s.k, 1, 0,
        0, 0, 0;
    state_ << 0, 0, 0, 1;
  }
  /// Just before a switching, if there is one at t.
  Eigen::Vector4d before(double t) {
    while (true) {
      const double next = switching(t);
      if (!(next < t)) return after(t - t_);
      state_ = after(next - t_);
      state_[3] = -state_[3];
      t_ = next;
      ++switchings;
    }
  }
  int switchings = 0;

 private:
  Eigen::Vector4d after(double s) const { return (s * all_).exp() * state_; }
  bool beyond(double s) const { return state_[3] * after(s)[0] > s_.width; }
  /// The first one up to t, seen by steps that are short beside a period.
  double switching(double t) const {
    double low = 0.0;
    for (const double step = 0.02 / s_.w; t_ + low < t; low += step) {
      const double far = std::min(low + step, t - t_);
      if (!beyond(far)) continue;
      double high = far;
      for (double middle = (low + high) / 2; middle > low && middle < high; middle = (low + high) / 2)
        (beyond(middle) ? high : low) = middle;
      return t_ + high;
    }
    return t;
  }

  RelaySystem s_;
  double t_;
  Eigen::Matrix4d all_;
  Eigen::Vector4d state_;
};

}  // namespace tandem::test
