// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/study/impulse_offer.hpp"

#include <algorithm>

#include "tandem/error.hpp"
#include "tandem/scenario/parts.hpp"
#include "tandem/scenario/taken.hpp"
#include "tandem/stability/fast_period.hpp"

namespace tandem::study {
namespace {

/// A rate of a displacement that goes to the fast side by itself lacks what that side does, and its damper feeds on it.
void refuse_past_surrogate(const scenario::Scenario& scenario, const Topology& topology) {
  const auto instance = [](const std::string& port) { return port.substr(0, port.find('.')); };
  const auto unit = [&](const std::string& name) {
    const Port* port = topology.output_port(name);
    return port ? port->unit : "";
  };
  const auto goes_past = [&](const Connection& c, const StatedLink& link) {
    return instance(c.from) == instance(link.back) && instance(c.to) == instance(link.effort) &&
           unit(c.from) == unit(link.back) + "/s";
  };
  for (const auto& entry : scenario.connections)
    for (const auto& one : scenario.links)
      if (const Connection& c = entry.connection;
          !is_back_of_link(scenario, c.from) && goes_past(c, one.link))
        scenario::refuse(entry.place, "connection from " + c.from + " to " + c.to +
                                          ": it goes past the surrogate; allowed is a rate that "
                                          "links.velocity names");
}

/// With its fast period; throws where it can't be opened.
scenario::Scenario coupled_by(const std::string& coupling, const scenario::Scenario& scenario,
                              const Builtins& builtins) {
  auto coupled = stability::with_fast_period(
      scenario::with_usual(scenario::with_taken(scenario, impulse_overrides(coupling))), builtins);
  refuse_past_surrogate(scenario, scenario::Parts(coupled, builtins, scenario::Code::run).topology());
  return coupled;
}

/// A stiffness that is stated is in `impulse` already.
std::vector<std::string> others(const scenario::Scenario& scenario) {
  const bool stated = std::any_of(scenario.links.begin(), scenario.links.end(),
                                  [](const auto& one) { return one.effective.stiffness.has_value(); });
  return stated ? std::vector<std::string>{"impulse_taylor"}
                : std::vector<std::string>{"impulse_stiffness", "impulse_taylor"};
}

}  // namespace

std::vector<std::string> impulse_overrides(const std::string& coupling) {
  return {"coordination.coupling=" + coupling, "coordination.carrier=automatic",
          "coordination.schedule=fastest-first"};
}

ImpulseOffer impulse_offer(const scenario::Scenario& scenario, const Builtins& builtins) {
  ImpulseOffer offer;
  try {
    offer.fast_period = coupled_by("impulse", scenario, builtins).fast_period;
    offer.couplings = {"impulse"};
  } catch (const Error& error) {
    offer.obstacle = error.what();
    return offer;
  }
  for (const std::string& one : others(scenario)) try {
      coupled_by(one, scenario, builtins);
      offer.couplings.push_back(one);
    } catch (const Error&) {
    }
  return offer;
}

bool is_back_of_link(const scenario::Scenario& scenario, const std::string& output) {
  return std::any_of(scenario.links.begin(), scenario.links.end(), [&](const scenario::LinkEntry& one) {
    return output == one.link.back || output == one.effective.velocity;
  });
}

bool is_of_link(const scenario::Scenario& scenario, const std::string& to) {
  const auto is_effort = [&](const std::string& from) {
    return std::any_of(scenario.links.begin(), scenario.links.end(),
                       [&](const scenario::LinkEntry& one) { return from == one.link.effort; });
  };
  return std::any_of(scenario.connections.begin(), scenario.connections.end(), [&](const auto& entry) {
    const std::string& from = entry.connection.from;
    return entry.connection.to == to && (is_effort(from) || is_back_of_link(scenario, from));
  });
}

}  // namespace tandem::study
