// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "tandem/charts/gnuplot.hpp"

namespace tandem::charts {

/// One axis of a panel: numbers, their logarithms, or words side by side. A y axis may have a grey strip
/// above it for what is no result: nothing is drawn there as if it were one.
class Axis {
 public:
  /// name: x or y. words: those at 0, 1, .., in place of numbers.
  Axis(char name, bool logarithmic, std::vector<std::string> words = {});

  /// Covers a value; what a logarithmic axis can't show is left out.
  void cover(double value);
  /// A strip of so many rows above `limit`, or above what is covered.
  void add_strip(int rows, std::optional<double> limit);

  /// Where a value is drawn: on a logarithmic axis one of 0 lies at the foot. Nothing for one that it can't
  /// show.
  std::optional<double> place(double value) const;
  /// Where row 0 (lowest) and those above are drawn.
  double strip(int row) const;
  bool logarithmic() const { return logarithmic_; }
  double low() const { return low_; }
  /// Between numbers of an axis in equal parts, three to seven of them.
  double step() const;
  double high() const { return strip_rows_ > 0 ? limit_ : high_; }

  /// Rounds what is covered to the ends of the axis. To be called once, after what it covers is known.
  void close();
  /// Sets it for the panels to come. numbers: whether the axis has any; most: for how many there is room.
  void apply(Picture& picture, const std::string& label, bool numbers, std::size_t most = 12) const;

 private:
  std::string tics(bool numbers, std::size_t most) const;
  std::vector<double> places(bool all, int step) const;
  std::string tics_of_words(bool numbers) const;

  char name_;
  bool logarithmic_;
  std::vector<std::string> words_;
  double low_ = std::numeric_limits<double>::infinity(), high_ = -low_;
  int strip_rows_ = 0;
  std::optional<double> wanted_limit_;
  double limit_ = 0.0, top_ = 0.0;
};

}  // namespace tandem::charts
