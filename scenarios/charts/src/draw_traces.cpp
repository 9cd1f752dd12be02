// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "axis.hpp"
#include "drawings.hpp"
#include "frame.hpp"
#include "looks.hpp"
#include "strips.hpp"

namespace tandem::charts {
namespace {

constexpr std::size_t most_points = 3000;  // of a curve in a window: no eye tells more apart

constexpr const char* reference_curve = "with lines lc rgb '#A6A6A6' lw 4 dt 1";

constexpr const char* jump_line = "with lines lc rgb '#808080' lw 1 dt '.'";

std::string style_of(const Trace& trace) {
  constexpr std::size_t blue = 4;
  return trace.is_reference ? reference_curve : "with lines " + Look{trace.look + blue, trace.look}.line();
}

/// Of more than most_points, every second, third ..
std::vector<Point> within(const std::vector<Point>& points, double from, double to) {
  std::vector<Point> inside, drawn;
  for (const Point& p : points)
    if (p.x >= from && p.x <= to) inside.push_back(p);
  const std::size_t stride = inside.size() / most_points + 1;
  for (std::size_t k = 0; k < inside.size(); k += stride) drawn.push_back(inside[k]);
  return drawn;
}

class TracesChart {
 public:
  TracesChart(const Chart& chart, const Charts& charts, const Table& table)
      : chart_(chart), charts_(charts), table_(table), strips_(chart, charts, table) {}

  Picture drawn() {
    std::vector<Quantity> shown;
    for (const auto& y : chart_.y) shown.insert(shown.end(), y.begin(), y.end());
    const int rows = static_cast<int>(strips_.all().size());
    Frame frame(chart_.name, {rows, 1, height(), 105, 10, 70},
                {chart_.title, {legend()}, table_.caption(chart_, shown)});
    for (int row = 0; row < rows; ++row) draw(frame, row);
    return frame.picture();
  }

 private:
  int height() const {
    const std::size_t rows = strips_.all().size();
    return rows > 3 ? 160 : rows > 1 ? 220 : 400;
  }

  /// Beside a panel a long one would reach into the next: it stands above.
  bool is_long(const std::string& label) const {
    constexpr std::size_t letter = 8;  // pixels
    return letter * label.size() > static_cast<std::size_t>(height());
  }

  std::vector<Curve> legend() const {
    std::vector<Curve> all;
    if (strips_.names().size() > 1 || !strips_.references().empty()) {
      for (const std::string& name : strips_.references()) all.push_back({"", reference_curve, name});
      for (std::size_t k = 0; k < strips_.names().size(); ++k)
        all.push_back({"", style_of({k, false, {}}), strips_.names()[k]});
    }
    if (!strips_.jumps().empty()) all.push_back({"", jump_line, charts_.name_of(chart_.jumps) + " changes"});
    return all;
  }

  std::vector<std::pair<double, double>> windows() const {
    std::vector<std::pair<double, double>> all;
    for (const auto& window : chart_.windows) all.emplace_back(window[0], window[1]);
    if (!all.empty()) return all;
    double from = std::numeric_limits<double>::infinity(), to = -from;
    for (const Strip& strip : strips_.all())
      for (const Trace& trace : strip.traces)
        for (const Point& p : trace.points) from = std::min(from, p.x), to = std::max(to, p.x);
    return {{from, to}};
  }

  void draw(Frame& frame, int row) const {
    const Strip& strip = strips_.all()[static_cast<std::size_t>(row)];
    const auto all = windows();
    for (std::size_t k = 0; k < all.size(); ++k) {
      const bool above = strip.title.empty() && is_long(strip.label);
      frame.go_to_window(row, k, all.size(), above ? strip.label : strip.title);
      draw_window(frame.picture(), strip, all[k].first, all[k].second, k == 0,
                  row + 1 == static_cast<int>(strips_.all().size()));
    }
  }

  void draw_window(Picture& picture, const Strip& strip, double from, double to, bool first,
                   bool last) const {
    const Axis y = axis_of(strip.kind, from, to);
    picture.command(
        fmt::format("{}; set clip two; set xrange [{:.12g}:{:.12g}]; set xtics autofreq; set format x '{}'; "
                    "set xlabel {} "
                    "noenhanced",
                    grid_command, from, to, last ? "%g" : "", quote(last ? x_label() : "")));
    const bool beside = first && !is_long(strip.label);
    y.apply(picture, beside ? strip.label : "", true);
    if (strips_.all().size() > 1) picture.command(fmt::format("set ytics {:.12g}", y.step()));
    std::vector<Curve> curves;
    for (const double jump : strips_.jumps())
      if (jump >= from && jump <= to)
        curves.push_back({picture.data({{jump, y.low()}, {jump, y.high()}}), jump_line});
    for (const Trace& trace : strip.traces)
      curves.push_back({picture.data(within(trace.points, from, to)), style_of(trace)});
    picture.plot(curves);
  }

  /// One for all panels of a kind, so that they can be compared.
  Axis axis_of(std::size_t kind, double from, double to) const {
    Axis y('y', false);
    for (const Strip& strip : strips_.all())
      if (strip.kind == kind)
        for (const Trace& trace : strip.traces)
          for (const Point& p : trace.points)
            if (p.x >= from && p.x <= to) y.cover(p.y);
    y.close();
    return y;
  }

  std::string x_label() const {
    const std::string& x = chart_.x.front().text;
    return x == "time" && !charts_.names.contains(x) ? "time [s]"
                                                     : table_.label(chart_.x.front(), charts_, false);
  }

  const Chart& chart_;
  const Charts& charts_;
  const Table& table_;
  Strips strips_;
};

}  // namespace

Picture draw_traces(const Chart& chart, const Charts& charts, const Table& table) {
  return TracesChart(chart, charts, table).drawn();
}

}  // namespace tandem::charts
