// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "split_pendulum/coupling.hpp"

#include <memory>

#include "tandem/error.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/subsystem.hpp"

namespace tandem::split_pendulum {

std::string run(const Coupling& c, Observer& observer) {
  mbs::StepperSettings stepper;
  stepper.formulation = c.formulation;
  std::vector<std::unique_ptr<Subsystem>> subsystems;
  std::vector<Subsystem*> members;
  Topology topology;
  for (const Side& side : c.sides) {
    subsystems.push_back(
        mbs::make_subsystem(mbs::read_mechanism(side.name, side.text), {side.step, stepper}));
    members.push_back(subsystems.back().get());
    topology.add(side.name, members.back()->info());
  }
  for (const Connection& connection : c.connections) topology.connect(connection);
  topology.check();
  Coordination coordination;
  coordination.schedule = Schedule::parse(c.schedule);
  Coordinator coordinator(topology, members, coordination, TimeSpan{0.0, c.t_stop});
  coordinator.observe(&observer);
  try {
    coordinator.run();
  } catch (const Error& error) {
    if (error.code() != ErrorCode::numerical) throw;
    return error.what();
  }
  return {};
}

}  // namespace tandem::split_pendulum
