// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>

#include "output_track.hpp"
#include "tandem/coordinator/indicators.hpp"
#include "used_input.hpp"

namespace tandem {

/// Parts of equal length that a run is divided into.
struct Windows {
  double begin = 0.0, length = 1.0, per_second = 1.0;
  std::size_t count = 0;
  std::size_t at(double t) const {
    return static_cast<std::size_t>(
        std::clamp((t - begin) * per_second, 0.0, static_cast<double>(count - 1)));
  }
};

/// The defect of one line.
class LineDefect {
 public:
  LineDefect(Indicators::Connection& told, const Line& line, std::size_t column)
      : told_(&told), column_(column), gain_(line.gain), offset_(line.offset) {}

  UsedInput used;
  // At the time that was looked at last; the defect is NaN where it is not known.
  double output = 0.0, defect = 0.0;

  std::size_t column() const { return column_; }
  double gain() const { return gain_; }

  void look(const OutputTrack& source, double t, std::size_t window) {
    output = source.value(column_);
    const double wanted = gain_ * output + offset_;
    defect = used.value(t) - wanted;
    const double size = std::abs(defect);
    if (std::isnan(size)) return;
    double& largest = told_->windows[window];
    if (size > largest) {
      largest = size;
      if (size > told_->largest) told_->largest = size, told_->at = t;
    }
    told_->peak = std::max(told_->peak, std::abs(wanted));
  }

 private:
  Indicators::Connection* told_;
  std::size_t column_;  ///< of the source's track
  double gain_, offset_;
};

}  // namespace tandem
