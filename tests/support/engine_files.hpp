// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "tandem/engine/compile.hpp"
#include "tandem/engine/make_integrator.hpp"
#include "tandem/engine/read.hpp"
#include "tandem/engine/simulation.hpp"

namespace tandem::test {

/// A diagram of scenarios/engine.
inline engine::Description engine_file(const std::string& name,
                                       const engine::ParameterValues& parameters = {}) {
  return engine::read_diagram(std::filesystem::path(TANDEM_SOURCE_DIR "/scenarios/engine") / name,
                              parameters);
}

inline double rpm(double speed) { return speed * 30.0 / std::numbers::pi; }

/// 8.97 deg, from 5 s on 11.93 deg; 25 N m, between 2 and 8 s 20 N m: the public example's inputs as blocks.
inline engine::Description open_loop(engine::Description engine) {
  using Wires = std::vector<engine::Wire>;
  engine.inputs.clear();
  engine.blocks.push_back({"throttle", "step", {{"time", 5.0}, {"before", 8.97}, {"after", 11.93}}});
  engine.blocks.push_back({"less", "step", {{"time", 2.0}, {"before", 25.0}, {"after", 20.0}}});
  engine.blocks.push_back({"more", "step", {{"time", 8.0}, {"after", 5.0}}});
  engine.blocks.push_back({"load", "sum", {{"inputs", Wires{"less", "more"}}}});
  return engine;
}

/// A diagram with constant inputs, and its outputs by name.
class EngineRun {
 public:
  EngineRun(const engine::Description& diagram, std::vector<double> inputs = {},
            const engine::IntegratorSettings& integrator = {},
            const engine::SimulationSettings& settings = {})
      : diagram_(diagram),
        program_(engine::compile(diagram)),
        inputs_(std::move(inputs)),
        simulation_(program_, &inputs_, engine::make_integrator(integrator), settings) {
    simulation_.start(0.0);
  }
  EngineRun(const EngineRun&) = delete;
  EngineRun& operator=(const EngineRun&) = delete;

  /// Own steps of h, up to t.
  void run(double t, double h = 1e-3) {
    for (long k = std::lround(simulation_.time() / h) + 1; k <= std::lround(t / h); ++k)
      simulation_.run(static_cast<double>(k) * h);
  }
  double operator[](const std::string& output) const {
    for (std::size_t k = 0; k < diagram_.outputs.size(); ++k)
      if (diagram_.outputs[k].name == output) return simulation_.output(static_cast<int>(k));
    throw std::out_of_range(output);
  }
  double time() const { return simulation_.time(); }

 private:
  class Constants final : public engine::InputSource {
   public:
    explicit Constants(std::vector<double> values) : values_(std::move(values)) {}
    void at(double, double* u) override { std::copy(values_.begin(), values_.end(), u); }

   private:
    std::vector<double> values_;
  };

  engine::Description diagram_;
  engine::Program program_;
  Constants inputs_;
  engine::Simulation simulation_;
};

}  // namespace tandem::test
