// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "engine_models/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tandem/engine/compile.hpp"
#include "tandem/engine/make_integrator.hpp"
#include "tandem/engine/read.hpp"
#include "tandem/engine/simulation.hpp"

namespace tandem::engine_models {
namespace {

namespace fs = std::filesystem;
using Wires = std::vector<engine::Wire>;

constexpr double step = 1e-3;  // [s]; wide open the manifold needs less than 2.7e-3
constexpr double per_rpm = std::numbers::pi / 30.0;

/// A diagram without inputs, by rk4, with its outputs in their order.
class Run {
 public:
  explicit Run(const engine::Description& diagram)
      : program_(engine::compile(diagram)), simulation_(program_, nullptr, engine::make_integrator({})) {
    simulation_.start(0.0);
  }
  void run(double t) {
    for (long k = std::lround(simulation_.time() / step) + 1; k <= std::lround(t / step); ++k)
      simulation_.run(static_cast<double>(k) * step);
  }
  double operator[](int output) const { return simulation_.output(output); }

 private:
  engine::Program program_;
  engine::Simulation simulation_;
};

void hold(engine::Description& d, const std::string& input, double value) {
  std::erase_if(d.inputs, [&](const engine::Input& i) { return i.name == input; });
  d.blocks.push_back({input, "constant", {{"value", value}}});
}

void jump(engine::Description& d, const std::string& input, double time, double before, double after) {
  std::erase_if(d.inputs, [&](const engine::Input& i) { return i.name == input; });
  d.blocks.push_back({input, "step", {{"time", time}, {"before", before}, {"after", after}}});
}

/// The crank of 1e9 kg m^2 keeps its speed while the manifold settles.
double steady_torque(const fs::path& folder, double rpm, double throttle) {
  auto d = engine::read_diagram(folder / "engine.toml", {{"J", 1e9}, {"N0", rpm * per_rpm}, {"P0", 0.5}});
  hold(d, "throttle", throttle);
  hold(d, "load", 0.0);
  Run run(d);
  run.run(3.0);
  return run[3];
}

}  // namespace

std::string torque_map(const fs::path& folder) {
  std::string text = "rpm,throttle,torque\n";
  for (const double throttle : {0.0, 5.0, 8.97, 12.0, 15.0, 20.0, 25.0, 50.0})
    for (double rpm = 800.0; rpm <= 6000.0; rpm += 200.0)
      text += fmt::format("{},{},{:.3f}\n", rpm, throttle, steady_torque(folder, rpm, throttle));
  return text;
}

std::string step_response(const fs::path& folder) {
  auto d = engine::read_diagram(folder / "governed_engine.toml");
  jump(d, "set", 5.0, 2000.0 * per_rpm, 3000.0 * per_rpm);
  jump(d, "less", 2.0, 25.0, 20.0);
  jump(d, "more", 8.0, 0.0, 5.0);
  d.inputs.clear();
  d.blocks.push_back({"load", "sum", {{"inputs", Wires{"less", "more"}}}});
  Run run(d);
  std::string text = "time,set,rpm,throttle,pressure,torque\n";
  for (int k = 0; k <= 2000; ++k) {
    const double t = 0.005 * k;
    run.run(t);
    text += fmt::format("{:.3f},{},{:.4f},{:.5f},{:.6f},{:.4f}\n", t, t < 5.0 ? 2000 : 3000, run[0] / per_rpm,
                        run[1], run[2], run[4]);
  }
  return text;
}

std::string manoeuvre(const fs::path& folder) {
  const auto d = engine::read_diagram(folder / "kart_monolithic.toml");
  const auto place = [&](const char* name) {
    const auto it =
        std::find_if(d.outputs.begin(), d.outputs.end(), [&](const auto& o) { return o.name == name; });
    return static_cast<int>(it - d.outputs.begin());
  };
  const int throttle = place("throttle"), gear = place("gear"), ratio = place("ratio"), fill = place("fill"),
            speed = place("N"), torque = place("torque"), pitch = place("pitch");
  Run run(d);
  std::string text = "time,throttle,gear,ratio,fill,rpm,torque,pitch\n";
  for (int k = 0; k <= 5000; ++k) {
    run.run(0.002 * k);
    text += fmt::format("{:.3f},{:.4f},{},{:.5f},{:.5f},{:.3f},{:.4f},{:.5f}\n", 0.002 * k, run[throttle],
                        run[gear], run[ratio], run[fill], run[speed] / per_rpm, run[torque], run[pitch]);
  }
  return text;
}

}  // namespace tandem::engine_models
