// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The relay and its plant in a coupled run, against their exact solution.
#pragma once
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "exact_relay.hpp"
#include "run_bench.hpp"

namespace tandem::test {

struct RelayRun {
  RelaySystem system = {};
  std::string schedule = "slowest-first", how = "lagrange3";
  double relay_step = 0.02, plant_step = 0.02;
  std::vector<std::string> order = {};
  double t_start = 0.0, span = 4.0;
  Landing landing = Landing::automatic;
  bool tells = true;  ///< else its relay is a QuietRelay
};

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
    if (what.tells) return std::make_unique<FixedStep<Relay>>(Relay(what.system, what.relay_step));
    return std::make_unique<FixedStep<QuietRelay>>(QuietRelay(what.system, what.relay_step));
  }

  RelayRun what_;
  std::unique_ptr<Subsystem> relay_;
  FixedStep<RelayPlant> plant_;
};

}  // namespace tandem::test
