// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "tandem/study/study.hpp"

namespace tandem::study {

inline bool is_in_window(const Metric& metric, double t) {
  return t >= metric.window.from && t <= metric.window.to;
}

/// What norms are made of, of values over time.
class NormOf {
 public:
  void add(double value) {
    squares_ += value * value;
    least_ = std::min(least_, value), most_ = std::max(most_, value);
    last_ = std::abs(value);
    ++count_;
  }
  double of(Metric::Norm norm) const {
    switch (norm) {
      case Metric::Norm::max:
        return std::max(std::abs(least_), std::abs(most_));
      case Metric::Norm::rms:
        return std::sqrt(squares_ / static_cast<double>(count_));
      case Metric::Norm::least:
        return least_;
      case Metric::Norm::most:
        return most_;
      case Metric::Norm::end:
        break;
    }
    return last_;
  }
  bool empty() const { return count_ == 0; }

 private:
  double squares_ = 0.0, last_ = 0.0, least_ = std::numeric_limits<double>::infinity(), most_ = -least_;
  std::size_t count_ = 0;
};

}  // namespace tandem::study
