// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <string>

#include "charts/gnuplot.hpp"
#include "charts/style.hpp"

namespace tandem::charts {

/// A logarithmic axis of errors in percent, up to failure_limit, with a grey strip above it for what failed
/// or has a larger error: there nothing is drawn as if it were a result.
class ErrorAxis {
 public:
  /// `smallest`: the smallest error to show, a fraction above 0; the axis begins just below, and never above
  /// a tenth of the limit. `rows`: the lines of the strip.
  ErrorAxis(double smallest, int rows);

  /// Whether an error is drawn as a result.
  bool shows(double error) const { return error <= failure_limit; }
  /// Where it is drawn then [percent]. An error of 0 lies at the axis' foot.
  double place(double error) const { return std::max(bottom_, 100.0 * error); }
  /// Where a failure is drawn [percent], in row 0 (lowest) to rows - 1.
  double strip(int row) const;
  /// Commands for the y axis of the panel to come: scale, range, tics, the strip and the text in it. Without
  /// a label the tics have no numbers either: the axis is that of the panel to the left.
  void apply(Picture& picture, const std::string& label, const std::string& strip_text) const;
  /// What apply() set and the panels to come should not inherit.
  static void end(Picture& picture);

 private:
  double bottom_, top_;  // percent
  int rows_;
};

}  // namespace tandem::charts
