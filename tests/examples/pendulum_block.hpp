// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A kind of block in C++ (docs/diagrams.md): a pendulum of 1 kg, driven by a torque.
#pragma once
#include <cmath>

#include "tandem/engine/compiled_block.hpp"

/// angle' = speed, speed' = torque / length^2 - 9.81 / length sin angle.
inline tandem::engine::CompiledBlock pendulum_block() {
  tandem::engine::CompiledBlock block;
  block.kind = "pendulum";
  block.inputs = {"torque"};
  block.outputs = {"angle", "speed"};
  block.parameters = {{"length"}};
  block.states = {{"angle"}, {"speed", 0.0}};
  block.output = [](const double*, const double* x, const double*, double* y) { y[0] = x[0], y[1] = x[1]; };
  block.rates = [](const double* p, const double* x, const double* u, double* dx) {
    dx[0] = x[1];
    dx[1] = u[0] / (p[0] * p[0]) - 9.81 / p[0] * std::sin(x[0]);
  };
  block.feedthrough = false;
  return block;
}
