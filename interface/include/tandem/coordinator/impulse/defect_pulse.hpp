// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>

#include "tandem/bytes.hpp"

namespace tandem {

/// Where the slow side came to other than its surrogate foresaw. It is spread over a step, so that no jump kicks the
/// fast side: e(s) = c3 x^3 + c4 x^4 + c5 x^5 with x = s / length. At the end that is the free motion of the defect.
class DefectPulse {
 public:
  DefectPulse() = default;
  /// Of a position and a velocity, over so long [s].
  DefectPulse(double position, double velocity, double length)
      : b_(length * velocity), a_(position + b_), length_(length) {}

  double value(double s) const {
    const double x = s / length_;
    return x * x * x * (c3() + x * (c4() + x * c5()));
  }
  double rate(double s) const {
    const double x = s / length_;
    return x * x * (3.0 * c3() + x * (4.0 * c4() + x * 5.0 * c5())) / length_;
  }
  double acceleration(double s) const {
    const double x = s / length_;
    return x * (6.0 * c3() + x * (12.0 * c4() + x * 20.0 * c5())) / (length_ * length_);
  }
  /// The same as c0 + c1 s + c2 s^2 + c3 s^3.
  std::array<double, 4> polynomial() const {
    const double square = length_ * length_, cube = square * length_;
    return {0.0, 6.0 * c3() / cube, 12.0 * c4() / (square * square), 20.0 * c5() / (square * cube)};
  }
  /// The free motion, s [s] from the begin.
  double free(double s) const { return a_ + b_ * (s / length_ - 1.0); }
  double free_rate() const { return b_ / length_; }

  /// The next one begins, s ago, where this one ends, and went on past its end: it goes over into its free motion. Of a
  /// position and a velocity that have it in them.
  void turn_to(const DefectPulse& next, double s, double& position, double& velocity) {
    const double end = length_ + s;
    position += next.value(s) - (value(end) - free(end));
    velocity += next.rate(s) - (rate(end) - free_rate());
    *this = next;
  }

  /// What it keeps but for its length.
  std::array<double*, 2> numbers() { return {&a_, &b_}; }

  void write(ByteWriter& to) const { to.put(a_), to.put(b_), to.put(length_); }
  void read(ByteReader& from) {
    for (double* one : {&a_, &b_, &length_}) *one = from.take<double>();
  }

 private:
  double c3() const { return 10.0 * a_ - 4.0 * b_; }
  double c4() const { return 7.0 * b_ - 15.0 * a_; }
  double c5() const { return 6.0 * a_ - 3.0 * b_; }

  double b_ = 0.0, a_ = 0.0, length_ = 1.0;  ///< [m]: a at the end, b of that by the velocity
};

}  // namespace tandem
