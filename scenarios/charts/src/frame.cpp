// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "frame.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tandem::charts {
namespace {

constexpr int head = 38, line = 18, between = 8;  // pixels: the title, a line of a legend, after it
constexpr int caption_line = 14, letter = 9;

int width_of(const Frame::Grid& grid) {
  if (grid.width > 0) return grid.width;
  return grid.columns == 1 ? 1000 : grid.columns == 2 ? 1200 : grid.columns == 3 ? 1300 : 1400;
}

int legend_columns(const std::vector<Curve>& entries, int width) {
  std::size_t longest = 0;
  for (const Curve& one : entries) longest = std::max(longest, one.title.size());
  const int room = std::max(1, (width - 60) / (letter * static_cast<int>(longest) + 70));
  return std::min(room, static_cast<int>(entries.size()));
}

int legend_height(const std::vector<Curve>& entries, int width) {
  if (entries.empty()) return 0;
  const int columns = legend_columns(entries, width), count = static_cast<int>(entries.size());
  return line * ((count + columns - 1) / columns) + between;
}

int top_of(const Surroundings& around, int width) {
  int top = around.title.empty() ? between : head;
  for (const auto& legend : around.legends) top += legend_height(legend, width);
  return top;
}

std::vector<std::string> caption_of(const Surroundings& around, int width) {
  return broken(around.caption, static_cast<std::size_t>(width / 7));
}

int height_of(const Frame::Grid& grid, const Surroundings& around, int width) {
  const int caption = caption_line * static_cast<int>(caption_of(around, width).size()) + 6;
  return top_of(around, width) + grid.rows * grid.height + grid.foot + caption;
}

}  // namespace

Frame::Frame(const std::string& name, Grid grid, const Surroundings& around)
    : grid_(grid),
      width_(width_of(grid)),
      top_(top_of(around, width_)),
      height_(height_of(grid, around, width_)),
      picture_(name, width_, height_) {
  picture_.title(around.title);
  picture_.caption(caption_of(around, width_));
  double from = around.title.empty() ? between : head;
  for (const auto& legend : around.legends) {
    const double to = from + legend_height(legend, width_);
    if (!legend.empty())
      picture_.legend({0.03, 0.97, 1.0 - (to - between) / height_, 1.0 - from / height_}, legend,
                      legend_columns(legend, width_));
    from = to;
  }
}

void Frame::go_to(int row, int column, const std::string& title) {
  const double own = 1.0 / grid_.columns;
  go_to(row, column * own, (column + 1) * own, 30.0, title);
}

void Frame::go_to_window(int row, std::size_t which, std::size_t count, const std::string& title) {
  const double own = 1.0 / static_cast<double>(count);
  go_to(row, static_cast<double>(which) * own, static_cast<double>(which + 1) * own, 65.0, title);
}

void Frame::go_to(int row, double left, double right, double gap, const std::string& title) {
  constexpr int title_height = 24, last = 20;  // pixels: above a panel, at the right edge
  const double room = width_ - grid_.left - last + gap;
  const double begin = grid_.left + room * left, end = grid_.left + room * right - gap;
  const double above = top_ + row * grid_.height + title_height,
               below = top_ + (row + 1) * grid_.height - grid_.numbers;
  picture_.panel({begin / width_, end / width_, 1.0 - below / height_, 1.0 - above / height_});
  picture_.command("set title " + quote(title) + " noenhanced offset 0,-0.6");
}

std::vector<std::string> broken(const std::vector<std::string>& lines, std::size_t width) {
  std::vector<std::string> all;
  for (std::string rest : lines) {
    while (rest.size() > width) {
      std::size_t end = rest.rfind(' ', width);
      if (end == std::string::npos || end == 0) end = width;
      all.push_back(rest.substr(0, end));
      rest.erase(0, rest.find_first_not_of(' ', end));
    }
    all.push_back(rest);
  }
  return all;
}

}  // namespace tandem::charts
