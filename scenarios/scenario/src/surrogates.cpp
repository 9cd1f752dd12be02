// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The surrogates of an impulse coupling, made from how their sides start.
#include <algorithm>

#include "impulse.hpp"
#include "impulse_parameters.hpp"
#include "slow_side.hpp"
#include "tandem/coordinator/impulse/taylor_surrogate.hpp"
#include "tandem/error.hpp"
#include "tandem/nearest.hpp"

namespace tandem::scenario {
namespace {

/// Each node takes some evaluations with the square of it, and a step as many terms.
constexpr std::size_t most_coordinates = 16;

/// With the outputs that were asked for, if the slow side has all of them.
ImpulseEntry with_told(const ImpulseEntry& of, const SubsystemInfo& slow) {
  const auto has = [&](const std::string& name) {
    return std::any_of(slow.outputs.begin(), slow.outputs.end(),
                       [&](const Port& port) { return port.name == name; });
  };
  ImpulseEntry told = of;
  for (ImpulseEntry::Link& row : told.links) {
    if (row.effective.mass || !row.effective.accelerance.empty()) return of;
    for (const ImpulseEntry::Link& by : of.links) {
      const std::string port = accelerance_port(row.displacement, by.force);
      if (!has(port)) return of;
      row.effective.accelerance.push_back(of.slow + "." + port);
    }
  }
  return told;
}

ConnectionEntry between(const SubsystemEntry& surrogate, std::string from, std::string to,
                        Reconstruction how) {
  return {{std::move(from), std::move(to), how},
          surrogate.place,
          surrogate.place,
          surrogate.place,
          surrogate.place};
}

/// From the displacements, and from the outputs that tell the accelerance.
std::vector<ConnectionEntry> told_to(const SubsystemEntry& surrogate, const ImpulseEntry& of) {
  std::vector<ConnectionEntry> all;
  const std::size_t links = of.links.size();
  const auto port = [&](const char* name, const std::string& number) {
    return surrogate.name + "." + name + (links > 1 ? number : "");
  };
  for (std::size_t i = 0; i < links; ++i) {
    const std::string number = "_" + std::to_string(i + 1);
    all.push_back(between(surrogate, of.links[i].displacement, port("position", number),
                          Reconstruction{Reconstruction::Kind::taylor}));
    const auto& told = of.links[i].effective.accelerance;
    for (std::size_t k = 0; k < told.size(); ++k)
      all.push_back(between(surrogate, told[k], port("accelerance", number + "_" + std::to_string(k + 1)),
                            Reconstruction::parse("hermite")));
  }
  return all;
}

/// The subsystems of an entry; a fast one may have been left out.
struct Sides {
  const ImpulseEntry& entry;
  const Scenario& of;
  const Topology& topology;
  const std::vector<std::unique_ptr<Subsystem>>& all;

  Subsystem* named(const std::string& name) const {
    const auto number = topology.instance(name);
    if (!number) throw Error(ErrorCode::invalid_argument, unknown("subsystem", name, topology.names()));
    return all[static_cast<std::size_t>(*number)].get();
  }
  Subsystem& numbered(int i) const { return *all[static_cast<std::size_t>(i)]; }
  bool are_there() const {
    return named(entry.slow) && std::all_of(entry.links.begin(), entry.links.end(),
                                            [&](const ImpulseEntry::Link& one) { return named(one.fast); });
  }
};

/// Null where the slow side keeps its equations to itself.
std::shared_ptr<SlowModel> model_of(SlowSide& slow, const Subsystem& subsystem) {
  slow.free();  // it is to have started
  std::vector<SlowLink> links;
  for (std::size_t k = 0; k < slow.links(); ++k)
    links.push_back({static_cast<int>(slow.force(k).index), static_cast<int>(slow.displacement(k).index)});
  return subsystem.slow_model(links);
}

/// What a force at each link accelerates at its displacement is to be above 0.
void check_signs(const SlowSide& slow, SlowModel& model, const std::vector<double>& q) {
  const std::size_t n = q.size(), p = slow.links();
  std::vector<double> pushes(n * p), a(n), y(p), rates(p);
  model.pushes(q, pushes);
  for (std::size_t k = 0; k < p; ++k) {
    model.answer(q, std::span(pushes).subspan(k * n, n), a);
    model.motions(q, a, y, rates);
    slow.require_reaction(k, rates[k]);
  }
}

TaylorCoupling taylor_of(const Sides& sides, SlowSide& slow, std::shared_ptr<SlowModel> model) {
  TaylorCoupling c;
  const Begin begin = slow.free();
  for (std::size_t k = 0; k < slow.links(); ++k)
    c.links.push_back({slow.force(k).port->unit, slow.displacement(k).port->unit, slow.velocity_unit(k)});
  std::vector<double> q;
  for (const std::string& coordinate : model->coordinates()) {
    const ScalarPort port = slow.output(coordinate);
    slow.derivative(begin, port, 2);  // it is known
    q.push_back(slow.derivative(begin, port, 0)), c.velocities.push_back(slow.derivative(begin, port, 1));
  }
  if (q.size() > most_coordinates)
    slow.refuse("has " + std::to_string(q.size()) + " coordinates; allowed with impulse_taylor are up to " +
                std::to_string(most_coordinates));
  model->stand_at(sides.of.start);
  check_signs(slow, *model, q);
  c.model = std::move(model), c.tells_velocities = slow.has_velocities();
  c.slow_step = begin.step, c.fast_period = sides.of.fast_period;
  c.own_step = fast_step(sides.entry, sides.of, sides.topology,
                         [&](int i) -> Subsystem& { return sides.numbered(i); });
  slow.require_longer_step(begin.step, c.own_step);
  return c;
}

/// From the slow side's coordinates, and to its forces on them.
std::vector<ConnectionEntry> with_coordinates(const SubsystemEntry& surrogate, const std::string& slow,
                                              const SlowModel& model) {
  std::vector<ConnectionEntry> all;
  const auto coordinates = model.coordinates(), reactions = model.reactions();
  const int n = static_cast<int>(coordinates.size());
  const Port in{"coordinates", "", n}, out{"reaction", "", n};
  for (int k = 0; k < n; ++k) {
    const auto i = static_cast<std::size_t>(k);
    all.push_back(between(surrogate, slow + "." + coordinates[i],
                          surrogate.name + "." + Scalar{&in, k}.name(),
                          Reconstruction{Reconstruction::Kind::taylor}));
    all.push_back(between(surrogate, surrogate.name + "." + Scalar{&out, k}.name(), slow + "." + reactions[i],
                          Reconstruction{Reconstruction::Kind::matched_hold}));
  }
  return all;
}

Surrogate by_taylor(const SubsystemEntry& entry, const Sides& sides) {
  Subsystem& subsystem = *sides.named(sides.entry.slow);
  SlowSide slow(sides.entry, sides.of, sides.topology, subsystem);
  const auto model = model_of(slow, subsystem);
  if (!model)
    slow.refuse(
        "does not give its equations; allowed with impulse_taylor are mechanisms whose links are forces and "
        "positions of their own, and models of this program that give them");
  return {taylor_surrogate(taylor_of(sides, slow, model)), with_coordinates(entry, sides.entry.slow, *model),
          sides.entry.name(), "lagrange4"};
}

Surrogate by_numbers(const SubsystemEntry& entry, const Sides& sides) {
  const ImpulseEntry impulse = with_told(sides.entry, sides.named(sides.entry.slow)->info());
  ImpulseCoupling coupling = impulse_coupling(impulse, sides.of, sides.topology,
                                              [&](int i) -> Subsystem& { return sides.numbered(i); });
  return {impulse_surrogate(coupling), told_to(entry, impulse), impulse.name(),
          coupling.stiffness.empty() ? "lagrange3" : "lagrange4", coupling};
}

}  // namespace

Surrogate surrogate_of(const SubsystemEntry& entry, const Scenario& of, const Topology& topology,
                       const std::vector<std::unique_ptr<Subsystem>>& subsystems) {
  return located(entry.place, [&]() -> Surrogate {
    const Sides sides{*entry.impulse, of, topology, subsystems};
    if (!sides.are_there() || lacks_fast_period(of)) return {};
    return entry.impulse->kind == ImpulseEntry::Kind::taylor ? by_taylor(entry, sides)
                                                             : by_numbers(entry, sides);
  });
}

}  // namespace tandem::scenario
