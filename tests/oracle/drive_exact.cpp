// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Prints the exact motion of scenarios/drive as its reference: exact.csv, each millisecond.
#include <cstdio>

#include "drive_scene.hpp"

int main() {
  auto exact = tandem::test::exact_drive();
  std::printf("time,load.speed,load.drum_speed,load.twist\n");
  for (int k = 0; k <= 600; ++k) {
    const auto y = exact.before(tandem::test::drive_load, 1e-3 * k);
    std::printf("%.3f,%.12g,%.12g,%.12g\n", 1e-3 * k, y[0], y[1], y[2]);
  }
}
