// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "four_bar/linkage.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace tandem::four_bar {
namespace {

/// The crank a time later.
Crank advance(int loops, Crank s, double time) {
  const double c = 1.5 * 9.81 * (3.0 * loops + 1.0) / (4.0 * loops + 1.0);
  const auto count = std::max(1L, std::lround(time / 1e-4));
  const double h = time / static_cast<double>(count);
  for (long k = 0; k < count; ++k) {
    const double a1 = c * std::sin(s.angle), r2 = s.rate + h / 2 * a1,
                 a2 = c * std::sin(s.angle + h / 2 * s.rate), r3 = s.rate + h / 2 * a2,
                 a3 = c * std::sin(s.angle + h / 2 * r2), r4 = s.rate + h * a3,
                 a4 = c * std::sin(s.angle + h * r3);
    s = {s.angle + h / 6 * (s.rate + 2 * r2 + 2 * r3 + r4), s.rate + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)};
  }
  return s;
}

constexpr Crank upright{0.0, 1.0}, hanging{std::numbers::pi, -1.0};

}  // namespace

std::string text(int loops, Start start) {
  std::string text =
      fmt::format("name = \"four_bar_{}\"\ndimension = 2\ngravity = [0, -9.81]\n\n[points]\n", loops);
  const int height = start == Start::upright ? 1 : -1;
  for (int i = 0; i <= loops; ++i)
    text += fmt::format("B{0} = {{ at = [{0}, {1}], velocity = [1, 0] }}\n", i, height);
  for (int i = 0; i <= loops; ++i) text += fmt::format("A{0} = {{ at = [{0}, 0], fixed = true }}\n", i);
  text += "\n[rods]\n";
  for (int i = 0; i <= loops; ++i)
    text += fmt::format("crank{0} = {{ points = [\"A{0}\", \"B{0}\"], mass = 1 }}\n", i);
  for (int i = 0; i < loops; ++i)
    text += fmt::format("coupler{0} = {{ points = [\"B{0}\", \"B{1}\"], mass = 1 }}\n", i, i + 1);
  return text + "\n[run]\nstop = 20\nstep = 1.25e-3\npenalty = 1e8\n";
}

Crank exact(int loops, double time) { return advance(loops, upright, time); }

std::vector<Crank> exact_path(int loops, Start start, double interval, int count) {
  std::vector<Crank> path{start == Start::upright ? upright : hanging};
  for (int k = 0; k < count; ++k) path.push_back(advance(loops, path.back(), interval));
  return path;
}

}  // namespace tandem::four_bar
