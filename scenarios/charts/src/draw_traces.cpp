// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

#include "axis.hpp"
#include "drawings.hpp"
#include "frame.hpp"
#include "groups.hpp"
#include "looks.hpp"
#include "tandem/charts/style.hpp"

namespace tandem::charts {
namespace {

constexpr std::size_t most_points = 3000;  // of a curve in a window: no eye tells more apart

constexpr const char* reference_curve = "with lines lc rgb '#A6A6A6' lw 4 dt 1";

struct Trace {
  std::size_t look;
  bool is_reference;
  std::vector<Point> points;
};

/// One panel: a quantity or several, or their differences from a reference. Those of one kind have one axis.
struct Strip {
  std::string title, label;
  std::size_t kind;
  std::vector<Trace> traces;
};

class TracesChart {
 public:
  TracesChart(const Chart& chart, const Charts& charts, const Table& table)
      : chart_(chart), charts_(charts), table_(table), rows_(table.chosen(chart.where)) {
    std::map<std::string, std::vector<std::size_t>> by_panel;
    for (const std::size_t row : rows_) {
      const std::string panel = table.words(row, chart.panels, chart.place, charts);
      panels_.of(panel);
      by_panel[panel].push_back(row);
    }
    for (const std::string& panel : panels_.names())
      for (std::size_t k = 0; k < chart.y.size(); ++k) add(panel, by_panel[panel], k);
    find_jumps();
  }

  Picture drawn() {
    std::vector<std::string> caption = chart_.notes;
    std::vector<Quantity> shown;
    for (const auto& y : chart_.y) shown.insert(shown.end(), y.begin(), y.end());
    for (std::string& line : table_.made(shown)) caption.push_back(std::move(line));
    const int rows = static_cast<int>(strips_.size());
    Frame frame(chart_.name,
                {rows, 1,
                 rows > 3   ? 160
                 : rows > 1 ? 220
                            : 400,
                 85, 10, 70},
                {chart_.title, {legend()}, caption});
    for (int row = 0; row < rows; ++row) draw(frame, row);
    return frame.picture();
  }

 private:
  /// "fast.x1.exact" beside "fast.x1".
  static bool is_reference(const Quantity& one, const std::vector<Quantity>& all) {
    return std::any_of(all.begin(), all.end(),
                       [&](const Quantity& other) { return one.text.starts_with(other.text + "."); });
  }

  /// That of the only quantity that is no reference.
  std::string label_of(const std::vector<Quantity>& y) const {
    std::vector<Quantity> own;
    std::copy_if(y.begin(), y.end(), std::back_inserter(own),
                 [&](const Quantity& one) { return !is_reference(one, y); });
    return own.size() == 1 ? table_.label(own[0], charts_, false) : "";
  }

  std::size_t look_of(std::size_t row, const std::vector<Quantity>& y, const Quantity& one) {
    std::string word = table_.words(row, chart_.series, chart_.place, charts_);
    if (y.size() > 1) word += (word.empty() ? "" : ", ") + table_.label(one, charts_, false);
    return is_reference(one, y) ? references_.of(word) : looks_.of(word);
  }

  void add(const std::string& panel, const std::vector<std::size_t>& rows, std::size_t which) {
    const auto& y = chart_.y[which];
    Strip strip{panel, label_of(y), 2 * which, {}}, difference = strip;
    ++difference.kind;
    for (const Quantity& one : y) {
      add_curves(strip, rows, one, y, {});
      if (!chart_.difference.empty())
        add_curves(difference, rows, one, y, Quantity{one.text + "." + chart_.difference, one.place});
    }
    strips_.push_back(std::move(strip));
    if (chart_.difference.empty()) return;
    difference.title +=
        (panel.empty() ? "" : ": ") + ("difference from " + charts_.name_of(chart_.difference));
    strips_.push_back(std::move(difference));
  }

  void add_curves(Strip& to, const std::vector<std::size_t>& rows, const Quantity& y,
                  const std::vector<Quantity>& all, const std::optional<Quantity>& less) {
    std::map<std::size_t, std::vector<Point>> curves;  // by look
    for (const std::size_t row : rows) {
      const auto x = table_.number(row, chart_.x.front()), value = table_.number(row, y);
      const auto reference = less ? table_.number(row, *less) : std::optional(0.0);
      if (x)
        curves[look_of(row, all, y)].push_back({*x, value && reference ? *value - *reference : undefined});
    }
    for (auto& [look, points] : curves) to.traces.push_back({look, is_reference(y, all), std::move(points)});
  }

  void find_jumps() {
    if (chart_.jumps.empty()) return;
    std::string before;
    for (const std::size_t row : rows_) {
      const std::string word = table_.words(row, {chart_.jumps}, chart_.place, charts_);
      const auto x = table_.number(row, chart_.x.front());
      if (row != rows_.front() && word != before && x && *x > last_x_) jumps_.push_back(*x);
      before = word, last_x_ = x.value_or(last_x_);
    }
    std::sort(jumps_.begin(), jumps_.end());
    jumps_.erase(std::unique(jumps_.begin(), jumps_.end()), jumps_.end());
  }

  std::vector<Curve> legend() const {
    std::vector<Curve> all;
    if (looks_.size() + references_.size() > 1) {
      for (const std::string& name : references_.names()) all.push_back({"", reference_curve, name});
      for (std::size_t k = 0; k < looks_.size(); ++k)
        all.push_back({"", style_of({k, false, {}}), looks_.names()[k]});
    }
    if (!jumps_.empty()) all.push_back({"", jump_line, charts_.name_of(chart_.jumps) + " changes"});
    return all;
  }

  std::vector<std::pair<double, double>> windows() const {
    std::vector<std::pair<double, double>> all;
    for (const auto& window : chart_.windows) all.emplace_back(window[0], window[1]);
    if (!all.empty()) return all;
    double from = std::numeric_limits<double>::infinity(), to = -from;
    for (const Strip& strip : strips_)
      for (const Trace& trace : strip.traces)
        for (const Point& p : trace.points) from = std::min(from, p.x), to = std::max(to, p.x);
    return {{from, to}};
  }

  void draw(Frame& frame, int row) const {
    const Strip& strip = strips_[static_cast<std::size_t>(row)];
    const auto all = windows();
    for (std::size_t k = 0; k < all.size(); ++k) {
      frame.go_to_window(row, k, all.size(), strip.title);
      draw_window(frame.picture(), strip, all[k].first, all[k].second, k == 0,
                  row + 1 == static_cast<int>(strips_.size()));
    }
  }

  void draw_window(Picture& picture, const Strip& strip, double from, double to, bool first,
                   bool last) const {
    const Axis y = axis_of(strip.kind, from, to);
    picture.command(
        fmt::format("{}; set xrange [{:.12g}:{:.12g}]; set xtics autofreq; set format x '{}'; set xlabel {} "
                    "noenhanced",
                    grid_command, from, to, last ? "%g" : "", quote(last ? x_label() : "")));
    y.apply(picture, first ? strip.label : "", true);
    std::vector<Curve> curves;
    for (const double jump : jumps_)
      if (jump >= from && jump <= to)
        curves.push_back({picture.data({{jump, y.low()}, {jump, y.high()}}), jump_line});
    for (const Trace& trace : strip.traces)
      curves.push_back({picture.data(within(trace.points, from, to)), style_of(trace)});
    picture.plot(curves);
  }

  static std::string style_of(const Trace& trace) {
    constexpr std::size_t blue = 4;
    return trace.is_reference ? reference_curve : "with lines " + Look{trace.look + blue, trace.look}.line();
  }

  /// One for all panels of a kind, so that they can be compared.
  Axis axis_of(std::size_t kind, double from, double to) const {
    Axis y('y', false);
    for (const Strip& strip : strips_)
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

  /// Of more than most_points, every second, third ..
  static std::vector<Point> within(const std::vector<Point>& points, double from, double to) {
    std::vector<Point> inside;
    for (const Point& p : points)
      if (p.x >= from && p.x <= to) inside.push_back(p);
    const std::size_t stride = inside.size() / most_points + 1;
    std::vector<Point> drawn;
    for (std::size_t k = 0; k < inside.size(); k += stride) drawn.push_back(inside[k]);
    return drawn;
  }

  static constexpr const char* jump_line = "with lines lc rgb '#808080' lw 1 dt '.'";
  const Chart& chart_;
  const Charts& charts_;
  const Table& table_;
  std::vector<std::size_t> rows_;
  Groups panels_, looks_, references_;
  std::vector<Strip> strips_;
  std::vector<double> jumps_;
  double last_x_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

Picture draw_traces(const Chart& chart, const Charts& charts, const Table& table) {
  return TracesChart(chart, charts, table).drawn();
}

}  // namespace tandem::charts
