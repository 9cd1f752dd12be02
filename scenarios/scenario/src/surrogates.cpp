// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The surrogates of an impulse coupling, made from how their sides start.
#include <algorithm>
#include <cmath>

#include "impulse.hpp"
#include "impulse_parameters.hpp"
#include "slow_side.hpp"
#include "tandem/coordinator/impulse/taylor_surrogate.hpp"
#include "tandem/error.hpp"
#include "tandem/nearest.hpp"

namespace tandem::scenario {
namespace {

/// From so many fast periods on a slow step sees aliases of the ripple where its effective mass varies.
constexpr double long_step = 0.3;
/// Their polynomials have terms with the square of it.
constexpr int most_coordinates = 16;

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

TaylorCoupling taylor_of(const Sides& sides, SlowSide& slow, std::shared_ptr<SlowModel> model) {
  TaylorCoupling c;
  const Begin begin = slow.free();
  for (std::size_t k = 0; k < slow.links(); ++k)
    c.links.push_back({slow.force(k).port->unit, slow.displacement(k).port->unit, slow.velocity_unit(k)});
  for (const std::string& coordinate : model->coordinates())
    c.velocities.push_back(slow.derivative(begin, slow.output(coordinate), 1));
  c.model = std::move(model), c.tells_velocities = slow.has_velocities();
  c.slow_step = begin.step, c.fast_period = sides.of.fast_period;
  c.own_step = fast_step(sides.entry, sides.of, sides.topology,
                         [&](int i) -> Subsystem& { return sides.numbered(i); });
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

/// By the slow side's own equations, if it gives them and the scene wants them.
std::optional<Surrogate> by_taylor(const SubsystemEntry& entry, const Sides& sides) {
  const bool wanted = sides.entry.kind == ImpulseEntry::Kind::taylor;
  if (!wanted && !sides.entry.may_be_taylor) return {};
  Subsystem& subsystem = *sides.named(sides.entry.slow);
  SlowSide slow(sides.entry, sides.of, sides.topology, subsystem);
  const auto model = model_of(slow, subsystem);
  if (!model && wanted)
    slow.refuse(
        "does not give its equations; allowed with impulse_taylor are mechanisms whose links are forces and "
        "positions, and models of this program that give them");
  if (!model) return {};
  return Surrogate{taylor_surrogate(taylor_of(sides, slow, model)),
                   with_coordinates(entry, sides.entry.slow, *model), "impulse_taylor", "lagrange4"};
}

Surrogate by_parameters(const SubsystemEntry& entry, const Sides& sides, const Builtins& builtins) {
  const ImpulseEntry impulse = with_told(sides.entry, sides.named(sides.entry.slow)->info());
  Opening opening;
  for (const Parameter& p : impulse_parameters(impulse, sides.of, sides.topology,
                                               [&](int i) -> Subsystem& { return sides.numbered(i); }))
    opening.parameters.set(p.name, p.value);
  return {open(entry.source, builtins, std::move(opening)), told_to(entry, impulse), impulse.name(),
          impulse.kind == ImpulseEntry::Kind::stiffness ? "lagrange4" : "lagrange3"};
}

}  // namespace

std::string wanted_reactions(const SubsystemEntry& slow, const Scenario& of, Subsystem& opened) {
  for (const SubsystemEntry& one : of.subsystems) {
    if (!one.impulse || one.impulse->slow != slow.name || !one.impulse->may_be_taylor) continue;
    const std::vector<double> unknown_inputs(static_cast<std::size_t>(opened.info().input_size()),
                                             std::nan(""));
    const double step = begin_of(opened, unknown_inputs, of).step;
    return step >= long_step * of.fast_period ? displacements_of(*one.impulse) : "";
  }
  return "";
}

bool has_reactions(const SubsystemInfo& slow) {
  const auto count = std::count_if(slow.inputs.begin(), slow.inputs.end(),
                                   [](const Port& one) { return one.name.starts_with("reaction."); });
  return count > 0 && count <= most_coordinates;
}

Surrogate surrogate_of(const SubsystemEntry& entry, const Scenario& of, const Topology& topology,
                       const std::vector<std::unique_ptr<Subsystem>>& subsystems, const Builtins& builtins) {
  return located(entry.place, [&]() -> Surrogate {
    const Sides sides{*entry.impulse, of, topology, subsystems};
    if (!sides.are_there()) return {};
    if (auto made = by_taylor(entry, sides)) return std::move(*made);
    return by_parameters(entry, sides, builtins);
  });
}

}  // namespace tandem::scenario
