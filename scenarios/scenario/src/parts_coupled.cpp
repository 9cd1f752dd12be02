// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Parts of a scenario that is coupled by impulse: its surrogates, beside their fast sides or as parts of them.
#include <algorithm>
#include <tuple>

#include "impulse.hpp"
#include "tandem/scenario/parts.hpp"

namespace tandem::scenario {

/// Beside their sides first, as there all that is said of them is checked.
void Parts::couple(Connections& connections, bool stand_ins) {
  std::vector<Surrogate> all;
  for (const SubsystemEntry& entry : scenario_.subsystems)
    if (entry.impulse) all.push_back(made(entry, connections));
  put_connections(connections);
  reactive_ = can_be_reactive(all, stand_ins);
  if (reactive_) put_guests(make_reactive(scenario_, topology_, all, subsystems_), connections);
}

Surrogate Parts::made(const SubsystemEntry& entry, Connections& connections) {
  Surrogate one = surrogate_of(entry, scenario_, topology_, subsystems_);
  if (one.subsystem) {
    const bool stays = one.by && one.by->accelerance_rate.empty();
    couplings_.push_back("subsystem '" + entry.impulse->slow + "' is coupled by " + one.coupling +
                         (stays ? ", by a constant effective mass" : ""));
    for (ConnectionEntry& to : connections)
      if (to.connection.to.starts_with(entry.name + ".force"))
        to.connection.how = Reconstruction::parse(one.continues);
    connections.insert(connections.end(), one.connections.begin(), one.connections.end());
  }
  keep(std::move(one.subsystem), {});
  put_instance(subsystems_.size() - 1);
  return one;
}

/// What is left out is not looked at, and what stands in for others may have no reactive inputs.
bool Parts::can_be_reactive(const std::vector<Surrogate>& made, bool stand_ins) {
  const auto is_left_out = [](const Surrogate& one) { return one.coupling.empty(); };
  if (scenario_.carrier == Carrier::surrogate || std::any_of(made.begin(), made.end(), is_left_out))
    return false;
  const std::string obstacle = reactive_obstacle(scenario_, topology_, made);
  if (obstacle.empty()) return true;
  if (scenario_.carrier == Carrier::reactive && !stand_ins)
    refuse(scenario_.place("coordination.carrier"),
           "coordination.carrier is reactive, and " + obstacle + "; allowed is surrogate");
  couplings_.push_back("coordination.carrier is surrogate, as " + obstacle);
  return false;
}

/// In place of the surrogates, whose connections with the fast sides are inside of these.
void Parts::put_guests(const std::vector<Guest>& guests, Connections& connections) {
  subsystems_.resize(subsystems_.size() - guests.size()), looks_.resize(subsystems_.size());
  std::vector<std::string> driven;
  for (const Guest& guest : guests) {
    const std::string fast = topology_.name(guest.instance) + ".", surrogate = guest.name + ".";
    couplings_.push_back("subsystem '" + topology_.name(guest.instance) + "' integrates '" + guest.name +
                         "' along");
    std::erase_if(connections, [&](const ConnectionEntry& one) {
      const auto& [from, to] = std::tie(one.connection.from, one.connection.to);
      const bool back = from.starts_with(surrogate) && to.starts_with(fast);
      if (back) driven.push_back(to);
      return back || (from.starts_with(fast) && to.starts_with(surrogate));
    });
  }
  topology_ = Topology();
  put_instances();
  for (const Guest& guest : guests) topology_.add_guest(guest.name, guest.instance);
  for (const std::string& input : driven) topology_.set_start(input, 0.0);
  put_connections(connections);
}

Coordination Parts::coordination() const {
  Coordination all = scenario_.coordination;
  for (const SubsystemEntry& entry : scenario_.subsystems)
    if (entry.impulse && reactive_) std::erase(all.order, entry.name);
  return all;
}

bool Parts::is_of_surrogate(const Line& line) const {
  if (!by_impulse(scenario_)) return false;
  const std::string from = topology_.output_name(line.source, line.output),
                    to = topology_.input_name(line.reader, line.input);
  return std::any_of(
      scenario_.subsystems.begin(), scenario_.subsystems.end(), [&](const SubsystemEntry& one) {
        return one.impulse && (from.starts_with(one.name + ".") || to.starts_with(one.name + "."));
      });
}

std::string Parts::note_of(int instance, const std::string& remark) const {
  for (const SubsystemEntry& entry : scenario_.subsystems)
    if (entry.impulse && reactive_ && remark.starts_with(entry.name + ": "))
      return "subsystem '" + entry.name + "'" + remark.substr(entry.name.size());
  return "subsystem '" + topology_.name(instance) + "': " + remark;
}

}  // namespace tandem::scenario
