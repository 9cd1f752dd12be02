// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "engine_linkage/truth.hpp"

#include <chrono>
#include <cmath>

#include "engine_linkage/monolithic.hpp"
#include "tandem/engine/compile.hpp"
#include "tandem/engine/make_integrator.hpp"
#include "tandem/engine/simulation.hpp"

namespace tandem::engine_linkage {

Truth::Truth(const engine::Description& engine, int loops, double t_stop) {
  const auto program = engine::compile(monolithic(engine, loops));
  const engine::IntegratorSettings settings{
      .name = "cvode_adams", .adaptive = {.relative_tolerance = 1e-10, .absolute_tolerance = 1e-12}};
  engine::Simulation run(program, nullptr, engine::make_integrator(settings));
  const int speed = static_cast<int>(program.outputs.size()) - 1;
  const auto began = std::chrono::steady_clock::now();
  run.start(0.0);
  speeds_.push_back(run.output(speed));
  for (long k = 1; k <= std::lround(t_stop / grid); ++k) {
    for (const double t = static_cast<double>(k) * grid; run.time() < t;) run.step(t);
    speeds_.push_back(run.output(speed));
  }
  seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

double Truth::speed(double t) const { return speeds_.at(static_cast<std::size_t>(std::lround(t / grid))); }

}  // namespace tandem::engine_linkage
