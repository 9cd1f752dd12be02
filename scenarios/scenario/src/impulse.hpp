// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tandem/coordinator/impulse/impulse_surrogate.hpp"
#include "tandem/coordinator/topology.hpp"
#include "tandem/scenario/scenario.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::scenario {

/// Puts a surrogate between each slow side and the fast ones that [[links]] names: it stands as one more subsystem at the
/// end, and the connections of the links go through it. Its parameters are not known yet.
/// Precondition: `to` is read but for what comes after [coordination].
/// - coupling: "impulse", "impulse_plain", "impulse_stiffness" or "impulse_taylor".
void couple_by_impulse(const std::string& coupling, Scenario& to);

/// A surrogate's port of a link: of several links ports have numbers, "force_1".
inline std::string numbered(const std::string& port, std::size_t link, std::size_t links) {
  return links > 1 ? port + "_" + std::to_string(link + 1) : port;
}

/// A surrogate, and its connections with the slow side but for the mean forces.
struct Surrogate {
  std::unique_ptr<Subsystem> subsystem;
  std::vector<ConnectionEntry> connections;
  std::string coupling;                    ///< that it stands for
  const char* continues = "";              ///< the reconstruction of the force
  std::optional<ImpulseCoupling> by = {};  ///< none: by the slow side's own equations
};
/// It goes by how its slow side and its fast ones start; null where one of these was left out. Throws
/// Error for sides that it can't stand between.
/// - subsystems: of the instances.
Surrogate surrogate_of(const SubsystemEntry& entry, const Scenario& of, const Topology& topology,
                       const std::vector<std::unique_ptr<Subsystem>>& subsystems);

/// What keeps the fast sides from integrating these surrogates along; empty: they can. Each stands in the topology beside
/// its sides, with its connections.
/// - made: those of the scenario's entries, in their order.
std::string reactive_obstacle(const Scenario& of, const Topology& topology,
                              const std::vector<Surrogate>& made);
/// A surrogate that is a part of its fast side.
struct Guest {
  std::string name;
  int instance;
};
/// The fast sides with their surrogates. Precondition: there is no obstacle.
std::vector<Guest> make_reactive(const Scenario& of, const Topology& topology,
                                 const std::vector<Surrogate>& made,
                                 std::vector<std::unique_ptr<Subsystem>>& subsystems);

}  // namespace tandem::scenario
