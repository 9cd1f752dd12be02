// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "drawings.hpp"
#include "frame.hpp"
#include "legend.hpp"
#include "looks.hpp"
#include "panel_row.hpp"

namespace tandem::charts {
namespace {

/// Draws curves and work charts.
class PointsChart {
 public:
  PointsChart(const Chart& chart, const Charts& charts, const Table& table, const Table* overlay)
      : chart_(chart), charts_(charts), table_(table), points_(chart, charts, table) {
    for (std::size_t row = 0; row < chart.y.size(); ++row) rows_.emplace_back(chart, points_, row, overlay);
    const int count = static_cast<int>(points_.panels().size());
    across_ = std::min(count, chart.across > 0 ? chart.across : 4);
    lines_ = (count + across_ - 1) / across_;
  }

  Picture drawn() {
    const bool has_floor =
        std::any_of(rows_.begin(), rows_.end(), [](const PanelRow& row) { return row.has_floor(); });
    Frame frame(chart_.name, grid(), {chart_.title, legends(chart_, points_, has_floor), caption()});
    for (std::size_t row = 0; row < rows_.size(); ++row)
      for (std::size_t panel = 0; panel < points_.panels().size(); ++panel) draw_panel(frame, row, panel);
    return frame.picture();
  }

 private:
  bool has_long_words() const {
    std::size_t letters = 0;
    for (const std::string& word : points_.words()) letters += word.size();
    return letters > 40;
  }

  Frame::Grid grid() const {
    const int rows = lines_ * static_cast<int>(rows_.size());
    const int label = rows_.size() > 1 && chart_.x[0].text != chart_.x[1].text ? 22 : 0;
    const int numbers = 32 + label + (has_long_words() ? 60 : 0);
    return {rows, across_, (rows == 1 ? 370 : 270) + numbers, 85, numbers, 45 - label};
  }

  std::vector<std::string> caption() const {
    std::vector<Quantity> shown = chart_.x;
    for (const auto& y : chart_.y) shown.insert(shown.end(), y.begin(), y.end());
    return table_.caption(chart_, shown);
  }

  void draw_panel(Frame& frame, std::size_t row, std::size_t panel) {
    Picture& picture = frame.picture();
    const int index = static_cast<int>(panel), column = index % across_;
    frame.go_to(static_cast<int>(row) * lines_ + index / across_, column, points_.panels()[panel]);
    picture.command(grid_command);
    const bool lowest = index + across_ >= static_cast<int>(points_.panels().size()) &&
                        (row + 1 == rows_.size() || chart_.x[row + 1].text != chart_.x[row].text);
    rows_[row].x().apply(picture, lowest ? table_.label(chart_.x[row], charts_, false) : "", true,
                         static_cast<std::size_t>(24 / across_));
    rows_[row].y().apply(picture, column == 0 ? y_label(row) : "", column == 0);
    picture.plot(rows_[row].curves(picture, panel));
    picture.command("unset label 99");
  }

  std::string y_label(std::size_t row) const {
    if (chart_.y[row].size() == 1) return table_.label(chart_.y[row].front(), charts_, chart_.percent);
    return chart_.percent ? "[%]" : "";
  }

  const Chart& chart_;
  const Charts& charts_;
  const Table& table_;
  Points points_;
  std::vector<PanelRow> rows_;
  int across_ = 1, lines_ = 1;  ///< panels side by side, and lines of them for each row
};

}  // namespace

Picture draw_points(const Chart& chart, const Charts& charts, const Table& table, const Table* overlay) {
  return PointsChart(chart, charts, table, overlay).drawn();
}

}  // namespace tandem::charts
