// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The relay and its plant in a coupled run, against their exact solution.
#pragma once
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "exact_relay.hpp"
#include "run_bench.hpp"
#include "tandem/engine/read.hpp"
#include "tandem/engine/subsystem.hpp"

namespace tandem::test {

struct RelayRun {
  RelaySystem system = {};
  std::string schedule = "slowest-first", how = "lagrange3";
  double relay_step = 0.02, plant_step = 0.02;
  std::vector<std::string> order = {};
  double t_start = 0.0, span = 4.0;
  Landing landing = Landing::automatic;
  enum class Model { exact, quiet, diagram } model = Model::exact;  ///< of the relay
  engine::IntegratorSettings integrator = {};                       ///< of the diagram
};

/// The same as Relay.
inline std::unique_ptr<Subsystem> relay_diagram(const RelaySystem& s, const engine::SubsystemSettings& how) {
  const std::string text = fmt::format(
      "[inputs]\nx = {{ unit = 'm' }}\n[blocks]\n"
      "r = {{ kind = 'relay', input = 'x', low = {}, high = {}, on = -1, off = 1 }}\n"
      "rate = {{ kind = 'sum', inputs = ['x', 'r', 'z'], gains = [1, 1, {}] }}\n"
      "z = {{ kind = 'integrator', input = 'rate' }}\n"
      "y = {{ kind = 'sum', inputs = ['z', 'r'], gains = [1, {}] }}\n"
      "[outputs]\nr = {{ unit = '1' }}\ny = {{ unit = '1' }}\n",
      -s.width, s.width, -s.k, s.jump);
  return engine::make_subsystem(engine::read_diagram("relay", text), how);
}

/// The coupled run, with its parts put together.
class RelayBench {
 public:
  explicit RelayBench(const RelayRun& what)
      : what_(what), relay_(make(what)), plant_(RelayPlant(what.system, what.plant_step)) {
    bench.add("relay", *relay_).add("plant", plant_).schedule(what.schedule);
    bench.connect("plant.x", "relay.x", what.how).connect("relay.y", "plant.y", what.how);
    bench.connect("relay.r", "plant.r", "");
    bench.coordination.order = what.order;
    bench.coordination.landing["plant"] = what.landing;
  }
  std::vector<Recording::Rows> run() { return bench.run(what_.t_start + what_.span, what_.t_start).all(); }
  /// The largest error of x in all rows of a run.
  double error(const std::vector<Recording::Rows>& rows) const {
    ExactRelay exact(what_.system, what_.t_start);
    double worst = 0.0;
    for (const auto& row : rows[1]) worst = std::max(worst, std::abs(exact.before(row[0])[0] - row[2]));
    return worst;
  }

  RunBench bench;

 private:
  static std::unique_ptr<Subsystem> make(const RelayRun& what) {
    using enum RelayRun::Model;
    if (what.model == diagram) return relay_diagram(what.system, {what.relay_step, what.integrator, {}});
    if (what.model == exact) return std::make_unique<FixedStep<Relay>>(Relay(what.system, what.relay_step));
    return std::make_unique<FixedStep<QuietRelay>>(QuietRelay(what.system, what.relay_step));
  }

  RelayRun what_;
  std::unique_ptr<Subsystem> relay_;
  FixedStep<RelayPlant> plant_;
};

}  // namespace tandem::test
