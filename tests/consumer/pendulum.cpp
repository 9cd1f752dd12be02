// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A program outside tandem's tree: a mechanism from its text, as a subsystem that advances by itself.
#include <cmath>
#include <cstdio>
#include <vector>

#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/subsystem.hpp"

int main() {
  const auto pendulum = tandem::mbs::make_subsystem(tandem::mbs::read_mechanism("pendulum", R"(
dimension = 2
gravity = [0, -9.81]
points.O = { at = [0, 0], fixed = true }
points.P = { at = [1e-3, -1] }
rods.r = { points = ["O", "P"], mass = 1 }
outputs.x = { position = "P.x" }
)"),
                                                    {1e-3, {}});
  constexpr std::int64_t room = 1001, stride = tandem::Samples::header + 3;  // x and two derivatives
  std::vector<double> rows(room * stride);
  tandem::Samples samples(rows.data(), stride, room);
  pendulum->initialize(0.0, 1.0, {}, samples);
  pendulum->advance(1.0, true, {}, samples);
  // Small swings of a uniform rod: x = 1 mm cos(w t), w^2 = 3 g / (2 l). The amplitude adds 6e-8 of the
  // angle, the trapezoidal rule (w h)^2 / 12 of it.
  const double x = samples.values(room - 1)[0], w = std::sqrt(1.5 * 9.81);
  const double error = std::abs(x - 1e-3 * std::cos(w));
  std::printf("pendulum after 1 s: %.9f m, error %.1e m\n", x, error);
  return error < 5e-9 ? 0 : 1;
}
