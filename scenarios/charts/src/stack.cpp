// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/charts/stack.hpp"

#include "tandem/charts/style.hpp"

namespace tandem::charts {
namespace {

constexpr double gap = 34.0;                // pixels, for a title
constexpr double bottom = 0.09, top = 0.9;  // fractions of the height, for caption and legend

}  // namespace

Stack::Stack(Picture& picture, std::size_t panels, std::string ylabel)
    : picture_(picture), panels_(panels), ylabel_(std::move(ylabel)) {
  picture_.command(std::string(grid_command) + "; set format x ''");
}

void Stack::next(const std::string& title) {
  ++row_;
  picture_.command("set title " + quote(title) + " noenhanced offset 0,-0.6; set ylabel " + quote(ylabel_));
  if (row_ == panels_) picture_.command("set format x '%g'; set xlabel 'time [s]'");
}

void Stack::go_to(double left, double right) {
  const double height = (top - bottom) / static_cast<double>(panels_);
  const double upper = top - height * static_cast<double>(row_ - 1);
  picture_.panel({left, right, upper - height + gap / picture_.height(), upper});
}

}  // namespace tandem::charts
