// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "connection.hpp"
#include "recording.hpp"
#include "tandem/coordinator/coordinator.hpp"

namespace tandem::test {

/// A run put together line by line; keeps every sample of it. The subsystems belong to the caller.
class RunBench {
 public:
  RunBench& add(const std::string& name, Subsystem& subsystem) {
    topology.add(name, subsystem.info());
    subsystems_.push_back(&subsystem);
    return *this;
  }
  RunBench& connect(const std::string& from, const std::string& to, const std::string& how = "lagrange0",
                    Lag lag = Lag::none) {
    topology.connect(connection(from, to, how, lag));
    return *this;
  }
  RunBench& schedule(const std::string& name) {
    coordination.schedule = Schedule::parse(name);
    return *this;
  }

  /// Checks the topology and runs to the end.
  const Recording& run(double t_stop, double t_start = 0.0) {
    recording = {};
    make(t_stop, t_start).observe(&recording);
    coordinator->run();
    return recording;
  }
  /// A coordinator that is not initialized yet and that nobody observes.
  Coordinator& make(double t_stop, double t_start = 0.0) {
    topology.check();
    return *(coordinator = std::make_unique<Coordinator>(topology, subsystems_, coordination,
                                                         TimeSpan{t_start, t_stop}));
  }

  Topology topology;
  Coordination coordination;
  Recording recording;
  std::unique_ptr<Coordinator> coordinator;

 private:
  std::vector<Subsystem*> subsystems_;
};

}  // namespace tandem::test
