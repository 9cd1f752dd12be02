// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "axis.hpp"
#include "points.hpp"

namespace tandem::charts {

/// A row of panels of curves and work charts: one quantity over another, with the same axes in each.
class PanelRow {
 public:
  /// overlay: the second table; null if the chart has none.
  PanelRow(const Chart& chart, const Points& points, std::size_t row, const Table* overlay);

  const Axis& x() const { return x_; }
  const Axis& y() const { return y_; }
  bool has_floor() const;
  /// What a panel shows. Its data, and the text in the band, go to the picture.
  std::vector<Curve> curves(Picture& picture, std::size_t panel) const;

 private:
  void cover();
  double shifted(const Mark& mark) const;
  void label_strip(Picture& picture, std::size_t nowhere) const;
  void add_series(Picture& picture, std::vector<const Mark*>& marks, std::vector<Curve>& to) const;
  void add_lines(Picture& picture, std::size_t panel, std::vector<Curve>& to) const;
  std::vector<Point> placed(const std::vector<Mark>& marks, std::size_t panel) const;

  const Chart& chart_;
  const Points& points_;
  const double factor_;
  std::vector<Mark> marks_, overlaid_;
  std::vector<std::optional<double>> floors_;  ///< by panel
  std::size_t strip_rows_ = 0;                 ///< 0: all are results
  Axis x_, y_;
};

}  // namespace tandem::charts
