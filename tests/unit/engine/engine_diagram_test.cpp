// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tandem/engine/compile.hpp"
#include "tandem/engine/integrators/runge_kutta.hpp"
#include "tandem/engine/read.hpp"
#include "tandem/engine/simulation.hpp"

namespace tandem::engine {
namespace {

/// 8.97 deg, from 5 s on 11.93 deg; 25 N m, between 2 and 8 s 20 N m.
class OpenLoop final : public InputSource {
 public:
  void at(double t, double* u) override {
    u[0] = t < 5.0 ? 8.97 : 11.93;
    u[1] = t > 2.0 && t <= 8.0 ? 20.0 : 25.0;
  }
};

/// The acceptance table of the engine, to the digits that it has, +- 1 in the last.
TEST(EngineDiagram, RunsAsTheAcceptanceTableSays) {
  const Program program =
      compile(read_diagram(std::filesystem::path(TANDEM_SOURCE_DIR "/scenarios/engine/engine.toml")));
  OpenLoop inputs;
  Simulation engine(program, &inputs, std::make_unique<RungeKutta4>());
  engine.start(0.0);
  const double table[][5] = {{1.9, 1999.4, 0.543, 0.1522, 25.00},
                             {4.9, 2174.6, 0.481, 0.1405, 20.00},
                             {7.9, 3206.8, 0.444, 0.1477, 20.12},
                             {9.99, 3002.9, 0.490, 0.1576, 24.90}};
  const double h = 1e-3;
  std::size_t row = 0;
  for (long k = 1; row < 4; ++k) {
    engine.step(static_cast<double>(k) * h);
    if (std::abs(engine.time() - table[row][0]) > 0.5 * h) continue;
    EXPECT_NEAR(engine.output(0) * 30.0 / std::numbers::pi, table[row][1], 0.1);
    EXPECT_NEAR(engine.output(1), table[row][2], 0.001);
    EXPECT_NEAR(engine.output(2), table[row][3], 0.0001);
    EXPECT_NEAR(engine.output(3), table[row][4], 0.01);
    ++row;
  }
}

}  // namespace
}  // namespace tandem::engine
