// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <utility>

#include "tandem/engine/compile.hpp"
#include "tandem/engine/make_integrator.hpp"
#include "tandem/engine/read.hpp"
#include "tandem/engine/simulation.hpp"

namespace tandem::test {

/// A diagram without inputs, from its blocks and outputs in TOML, that runs with a fixed step.
class DiagramRun {
 public:
  explicit DiagramRun(const std::string& text, const engine::IntegratorSettings& settings = {})
      : program(engine::compile(engine::read_diagram("diagram", text))),
        simulation(program, nullptr, engine::make_integrator(settings)) {}

  /// From 0 to t in so many steps.
  engine::Simulation& run(double t, int steps) {
    simulation.start(0.0);
    for (int k = 1; k <= steps; ++k)
      while (simulation.time() < t * k / steps) simulation.step(t * k / steps);
    return simulation;
  }

  engine::Program program;
  engine::Simulation simulation;
};

}  // namespace tandem::test
