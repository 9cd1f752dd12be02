// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>

#include "tandem/study/study.hpp"

namespace tandem::study {

inline bool is_in_window(const Metric& metric, double t) {
  return t >= metric.window.from && t <= metric.window.to;
}

/// A sum of squares, a largest and a last one of values over time.
class NormOf {
 public:
  void add(double value) {
    squares_ += value * value;
    largest_ = std::max(largest_, std::abs(value));
    last_ = std::abs(value);
    ++count_;
  }
  double of(Metric::Norm norm) const {
    return norm == Metric::Norm::max   ? largest_
           : norm == Metric::Norm::rms ? std::sqrt(squares_ / static_cast<double>(count_))
                                       : last_;
  }
  bool empty() const { return count_ == 0; }

 private:
  double squares_ = 0.0, largest_ = 0.0, last_ = 0.0;
  std::size_t count_ = 0;
};

}  // namespace tandem::study
