// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "impulse.hpp"

#include <algorithm>

namespace tandem::scenario {
namespace {

std::string instance_of(const std::string& port) { return port.substr(0, port.find('.')); }

/// The one that carries this output to an input of that instance.
ConnectionEntry& connection_of(Scenario& scenario, const LinkEntry& link, const std::string& output,
                               const std::string& reader) {
  ConnectionEntry* found = nullptr;
  for (ConnectionEntry& one : scenario.connections) {
    if (one.connection.from != output || instance_of(one.connection.to) != reader) continue;
    if (found)
      refuse(one.place,
             "'" + output + "' is read twice by '" + reader + "'; allowed in an impulse coupling is once");
    found = &one;
  }
  if (!found)
    refuse(link.place,
           "'" + output + "' is read by no connection to '" + reader +
               "' by itself; allowed in an impulse coupling is a connection of that output alone");
  const Connection& c = found->connection;
  if (c.lag != Lag::none || c.add)
    refuse(found->place,
           "the connection of an impulse coupling has memory, delay or add; allowed are neither");
  return *found;
}

void refuse_other_links(const LinkEntry& entry) {
  if (entry.link.kind != PowerLink::Kind::displacement)
    refuse(entry.place,
           "an impulse coupling is of a force and a displacement; allowed in [[links]] are effort and "
           "displacement");
}

/// A connection as it was, from or to the surrogate.
ConnectionEntry part(const ConnectionEntry& whole, std::string from, std::string to,
                     Reconstruction::Kind how) {
  ConnectionEntry one = whole;
  one.connection = {std::move(from), std::move(to), Reconstruction{how}};
  return one;
}

/// Takes a connection of a link out of the reconstruction that is stated for it.
ConnectionEntry& taken(Scenario& to, const LinkEntry& link, const std::string& output,
                       const std::string& reader) {
  ConnectionEntry& one = connection_of(to, link, output, reader);
  if (one.connection.how && one.connection.how->kind == Reconstruction::Kind::matched_hold)
    refuse(one.place,
           "connection from " + output + " to " + one.connection.to +
               ": matched_hold is no reconstruction for a link that is coupled by impulse, which has "
               "a mean force of its own; allowed is to leave it out");
  if (one.connection.how)
    to.remarks.push_back("connection from " + output + " to " + one.connection.to + ": " +
                         one.connection.how->name() + " is not used, as the link is coupled by impulse");
  one.connection.how.reset();
  return one;
}

/// What the fast side reads of the slow one comes from the surrogate, along its own course.
void take_back(Scenario& to, const LinkEntry& entry, const std::string& output, const std::string& from) {
  if (instance_of(output) != instance_of(entry.link.back))
    refuse(entry.place,
           "velocity is '" + output + "'; allowed is an output of '" + instance_of(entry.link.back) + "'");
  ConnectionEntry& back = taken(to, entry, output, instance_of(entry.link.effort));
  back.connection.from = from, back.connection.how = Reconstruction::parse("hermite");
}

void take_over(Scenario& to, const LinkEntry& entry, const std::string& surrogate, std::size_t link,
               std::size_t links) {
  const StatedLink& power = entry.link;
  const auto port = [&](const char* name) { return surrogate + "." + numbered(name, link, links); };
  ConnectionEntry& force = taken(to, entry, power.effort, instance_of(power.back));
  ConnectionEntry mean =
      part(force, port("mean_force"), force.connection.to, Reconstruction::Kind::matched_hold);
  force.connection.to = port("force");
  take_back(to, entry, power.back, port("displacement"));
  if (const auto& velocity = entry.effective.velocity) take_back(to, entry, *velocity, port("velocity"));
  to.connections.push_back(std::move(mean));
}

/// All of them tell, or none, and each of all forces.
void check_accelerance(const std::vector<LinkEntry>& links, const std::string& slow) {
  for (const LinkEntry& link : links) {
    const auto& outputs = link.effective.accelerance;
    if (outputs.size() != (links[0].effective.accelerance.empty() ? 0 : links.size()))
      refuse(link.place, "accelerance names " + std::to_string(outputs.size()) + " outputs, and subsystem '" +
                             slow + "' has " + std::to_string(links.size()) +
                             " links; allowed is one output for each link, at each link or at none");
    for (const std::string& output : outputs)
      if (instance_of(output) != slow)
        refuse(link.place, "accelerance names '" + output + "'; allowed is an output of '" + slow + "'");
  }
}

/// Ports for its coordinates, those of the displacements first.
void ask_for_reactions(const ImpulseEntry& impulse, Scenario& to) {
  std::string all;
  for (const ImpulseEntry::Link& one : impulse.links)
    all += (all.empty() ? "" : ",") + one.displacement.substr(one.displacement.find('.') + 1);
  for (SubsystemEntry& entry : to.subsystems)
    if (entry.name == impulse.slow) entry.reactions = all;
}

/// Where a fast side reads more of the slow one than goes through the surrogate, also by another subsystem, it sees that
/// without its ripple.
void remark_on_others(const std::string& slow, const std::vector<LinkEntry>& links, Scenario& to) {
  const auto is_fast = [&](const std::string& reader) {
    return std::any_of(links.begin(), links.end(),
                       [&](const LinkEntry& link) { return instance_of(link.link.effort) == reader; });
  };
  const auto acts_on_fast = [&](const std::string& between) {
    return std::any_of(to.connections.begin(), to.connections.end(), [&](const ConnectionEntry& one) {
      return instance_of(one.connection.from) == between && is_fast(instance_of(one.connection.to));
    });
  };
  for (const ConnectionEntry& one : to.connections) {
    const Connection& c = one.connection;
    const std::string reader = instance_of(c.to);
    if (instance_of(c.from) != slow || !(is_fast(reader) || (reader != slow && acts_on_fast(reader))))
      continue;
    to.remarks.push_back("connection from " + c.from + " to " + c.to +
                         ": it goes past the surrogate, so that it has nothing of the fast motion; " +
                         (is_fast(reader)
                              ? "the rate of a displacement goes through it where links.velocity names it"
                              : "an output of '" + slow + "_surrogate' has it"));
  }
}

/// What the slow side is to tell, unless it is stated: each displacement by each force.
void ask_for_accelerances(const ImpulseEntry& impulse, Scenario& to) {
  std::string all;
  for (const ImpulseEntry::Link& row : impulse.links) {
    if (row.effective.mass || !row.effective.accelerance.empty()) return;
    for (const ImpulseEntry::Link& by : impulse.links)
      all += (all.empty() ? "" : ",") + accelerance_port(row.displacement, by.force);
  }
  for (SubsystemEntry& entry : to.subsystems)
    if (entry.name == impulse.slow) entry.accelerances = all;
}

/// Springs are for one link, and where they are stated, or wanted.
ImpulseEntry::Kind kind_of(const std::string& coupling, const std::vector<LinkEntry>& links, Scenario& to) {
  if (coupling == "impulse_taylor") return ImpulseEntry::Kind::taylor;
  const bool stated = links.size() == 1 && links[0].effective.stiffness;
  if (coupling == "impulse_stiffness" && links.size() != 1)
    refuse(links[0].place,
           "impulse_stiffness is for one link on a slow side; allowed for several are impulse_plain and "
           "impulse_taylor");
  const bool springs = coupling == "impulse_stiffness" || (stated && coupling == "impulse");
  if (stated && !springs) to.remarks.push_back("links.effective_stiffness is not used by " + coupling);
  return springs ? ImpulseEntry::Kind::stiffness : ImpulseEntry::Kind::plain;
}

bool stands_in(const std::vector<std::string>& all, const std::string& name) {
  return std::find(all.begin(), all.end(), name) != all.end();
}

/// Nothing is stated of it that a Taylor surrogate would not go by.
bool states_nothing(const std::vector<LinkEntry>& links) {
  return std::all_of(links.begin(), links.end(), [](const LinkEntry& one) {
    return !one.effective.mass && !one.effective.stiffness && one.effective.accelerance.empty();
  });
}

}  // namespace

void couple_by_impulse(const std::string& coupling, Scenario& to) {
  std::map<std::string, std::vector<LinkEntry>> by_slow;
  for (const LinkEntry& link : to.links)
    refuse_other_links(link), by_slow[instance_of(link.link.back)].push_back(link);
  if (by_slow.empty())
    refuse(to.place("coordination.coupling"),
           "coordination.coupling is impulse, and there are no [[links]]; allowed is a link with effort, the "
           "fast side's "
           "output, and displacement, the slow side's");
  std::vector<LinkEntry> coupled;
  for (const auto& [slow, links] : by_slow) {
    check_accelerance(links, slow);
    ImpulseEntry impulse{slow, {}, kind_of(coupling, links, to)};
    if (coupling == "impulse_taylor" && !states_nothing(links))
      refuse(
          links[0].place,
          "effective_mass, accelerance or effective_stiffness is stated, and impulse_taylor goes by the slow "
          "side's own equations; allowed is none of them");
    SubsystemEntry surrogate{
        slow + "_surrogate", std::string("builtin:") + impulse_model, {}, {}, links[0].place, links[0].place};
    for (std::size_t k = 0; k < links.size(); ++k) {
      const StatedLink& power = links[k].link;
      const std::string input = connection_of(to, links[k], power.effort, slow).connection.to;
      impulse.links.push_back({instance_of(power.effort), input, power.back, links[k].effective});
      take_over(to, links[k], surrogate.name, k, links.size());
      coupled.push_back(links[k]);
      coupled.back().link.back = surrogate.name + "." + numbered("displacement", k, links.size());
    }
    remark_on_others(slow, links, to);
    impulse.kind == ImpulseEntry::Kind::taylor ? ask_for_reactions(impulse, to)
                                               : ask_for_accelerances(impulse, to);
    surrogate.impulse = std::make_shared<const ImpulseEntry>(std::move(impulse));
    if (auto& order = to.coordination.order; !order.empty() && !stands_in(order, surrogate.name))
      order.push_back(surrogate.name);  // it leads
    to.subsystems.push_back(std::move(surrogate));
    Landing& lands = to.coordination.landing[slow];
    if (lands == Landing::always)
      refuse(links[0].place,
             "subsystem '" + slow +
                 "' has land = \"always\"; allowed with an impulse coupling is never, as its steps "
                 "are to be equal");
    lands = Landing::never;
  }
  to.links = std::move(coupled);
}

}  // namespace tandem::scenario
