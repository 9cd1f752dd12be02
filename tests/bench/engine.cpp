// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <memory>

#include "bench/bench.hpp"
#include "engine_models/compiled.hpp"
#include "tandem/engine/compile.hpp"
#include "tandem/engine/make_integrator.hpp"
#include "tandem/engine/read.hpp"
#include "tandem/engine/simulation.hpp"

namespace tandem::bench {
namespace {

constexpr double step_size = 1e-4;  // [s]
constexpr int engine_steps = 1000;

/// Steps of a diagram of scenarios/engine by rk4, 0.1 s of it again and again from its start.
class Diagram {
 public:
  Diagram(const std::string& file, const engine::ParameterValues& parts, bool drives)
      : program_(engine::compile(read(file, parts, drives))),
        simulation_(program_, nullptr, engine::make_integrator({})) {}
  void run() {
    simulation_.start(0.0);
    for (int k = 1; k <= engine_steps; ++k) simulation_.run(k * step_size);
  }

 private:
  /// drives: its inputs are constant.
  static engine::Description read(const std::string& file, const engine::ParameterValues& parts,
                                  bool drives) {
    auto d = engine::read_diagram(std::filesystem::path("scenarios/engine") / file, parts);
    d.kinds = engine_models::compiled_kinds();
    for (const auto& input : d.inputs)
      if (drives)
        d.blocks.push_back({input.name, "constant", {{"value", input.name == "throttle" ? 8.97 : 25.0}}});
    d.inputs.clear();
    return d;
  }

  engine::Program program_;
  engine::Simulation simulation_;
};

}  // namespace

Table engine_models() {
  const struct {
    const char *name, *listed_file, *compiled_file;
    engine::ParameterValues compiled;
  } models[] = {{"engine of form A", "engine.toml", "engine_compiled.toml", {}},
                {"kart with power train",
                 "kart_monolithic.toml",
                 "kart_monolithic.toml",
                 {{"engine", "engine_compiled.toml"}, {"gearbox", "kart_automatic_compiled.toml"}}}};
  std::vector<Timing> timings;
  const auto add = [&](const std::string& name, const char* file, const engine::ParameterValues& parts) {
    const auto diagram = std::make_shared<Diagram>(file, parts, std::string(file).starts_with("engine"));
    timings.push_back({name, [diagram](benchmark::State& state) {
                         for ([[maybe_unused]] auto _ : state) diagram->run();
                       }});
  };
  for (const auto& m : models)
    add(std::string(m.name) + "/listed", m.listed_file, {}),
        add(std::string(m.name) + "/compiled", m.compiled_file, m.compiled);
  auto seconds = measure(timings, 20, 0.02);
  Table table({"model", "listed_ns_per_step", "compiled_ns_per_step", "ratio"});
  for (const auto& m : models) {
    const double listed = seconds[std::string(m.name) + "/listed"] / engine_steps,
                 compiled = seconds[std::string(m.name) + "/compiled"] / engine_steps;
    table.add({m.name, fmt::format("{:.0f}", 1e9 * listed), fmt::format("{:.0f}", 1e9 * compiled),
               fmt::format("{:.2f}", listed / compiled)});
  }
  return table;
}

}  // namespace tandem::bench
