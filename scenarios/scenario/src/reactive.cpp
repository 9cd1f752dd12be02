// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Surrogates of an impulse coupling that the fast sides integrate along, by their reactive inputs.
#include <algorithm>

#include "impulse.hpp"
#include "tandem/coordinator/impulse/reactive_side.hpp"

namespace tandem::scenario {
namespace {

/// A surrogate as it stands beside its sides.
struct Beside {
  const SubsystemEntry& entry;
  const Surrogate& made;
  const Topology& topology;

  std::string fast() const { return entry.impulse->links[0].fast; }
  int instance() const { return *topology.instance(entry.name); }
  int fast_instance() const { return *topology.instance(fast()); }
  std::size_t links() const { return entry.impulse->links.size(); }

  std::vector<Line> lines(int from, int to) const {
    std::vector<Line> all;
    for (const Line& line : topology.lines())
      if (line.source == from && line.reader == to) all.push_back(line);
    return all;
  }
  /// Outputs of the surrogate are displacements, mean forces and velocities.
  std::vector<ReactiveLink> reactive_links() const {
    std::vector<ReactiveLink> all(links());
    for (const Line& line : lines(fast_instance(), instance()))
      all[static_cast<std::size_t>(line.input)].effort = {line.output, line.gain, line.offset};
    for (const Line& line : lines(instance(), fast_instance())) {
      const auto output = static_cast<std::size_t>(line.output);
      const ReactiveLink::End end{line.input, line.gain, line.offset};
      output < links() ? void(all[output].displacement = end)
                       : void(all[output - 2 * links()].velocity = end);
    }
    return all;
  }
  /// Slowest first: what comes later leads.
  bool stands_before(const std::string& slow, const std::vector<std::string>& order) const {
    const auto place = [&](const std::string& name) { return std::find(order.begin(), order.end(), name); };
    return !order.empty() && place(slow) > place(fast());
  }
  /// Empty: there is none.
  std::string obstacle(const SubsystemInfo& of_fast, const std::vector<std::string>& order) const {
    const auto& links = entry.impulse->links;
    const auto other =
        std::find_if(links.begin(), links.end(), [&](const auto& one) { return one.fast != fast(); });
    const auto velocities = std::count_if(links.begin(), links.end(),
                                          [](const auto& one) { return one.effective.velocity.has_value(); });
    if (!made.by) return "the surrogate of '" + entry.impulse->slow + "' goes by that side's own equations";
    if (other != links.end())
      return "'" + entry.impulse->slow + "' has links with '" + fast() + "' and with '" + other->fast + "'";
    if (stands_before(entry.impulse->slow, order))
      return "coordination.order puts '" + entry.impulse->slow + "' ahead of '" + fast() + "'";
    if (!of_fast.abilities.reactive_inputs) return "'" + fast() + "' has no reactive inputs";
    if (!made.by->stiffness.empty() && !made.by->accelerance_rate.empty())
      return "'" + entry.impulse->slow + "' has a stiffness and an accelerance that varies";
    if (std::ssize(lines(instance(), fast_instance())) != std::ssize(links) + velocities)
      return "'" + fast() + "' reads more of the surrogate than its links";
    return {};
  }
};

}  // namespace

std::string reactive_obstacle(const Scenario& of, const Topology& topology,
                              const std::vector<Surrogate>& made) {
  std::vector<std::string> taken;
  std::size_t k = 0;
  for (const SubsystemEntry& entry : of.subsystems) {
    if (!entry.impulse) continue;
    const Beside one{entry, made[k++], topology};
    if (auto why = one.obstacle(topology.info(one.fast_instance()), of.coordination.order); !why.empty())
      return why;
    if (std::count(taken.begin(), taken.end(), one.fast()) > 0)
      return "'" + one.fast() + "' has links with two slow sides";
    taken.push_back(one.fast());
  }
  return {};
}

std::vector<Guest> make_reactive(const Scenario& of, const Topology& topology,
                                 const std::vector<Surrogate>& made,
                                 std::vector<std::unique_ptr<Subsystem>>& subsystems) {
  std::vector<Guest> guests;
  std::size_t k = 0;
  for (const SubsystemEntry& entry : of.subsystems) {
    if (!entry.impulse) continue;
    const Surrogate& one = made[k++];
    const Beside beside{entry, one, topology};
    auto& fast = subsystems[static_cast<std::size_t>(beside.fast_instance())];
    std::vector<ReactiveLink> links = beside.reactive_links();
    fast = reactive_side(std::move(fast), *one.by, std::move(links), entry.name);
    guests.push_back({entry.name, beside.fast_instance()});
  }
  return guests;
}

}  // namespace tandem::scenario
