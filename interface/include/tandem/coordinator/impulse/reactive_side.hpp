// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tandem/coordinator/impulse/impulse_surrogate.hpp"

namespace tandem {

/// A link of a fast side that carries the reaction of the slow one: what a connection makes of one scalar for another.
struct ReactiveLink {
  struct End {
    int port;  ///< scalar output or input of the fast side, flattened
    double gain = 1.0, offset = 0.0;
  };
  End effort;        ///< its output, and the slow side's force from it
  End displacement;  ///< its input, from the surrogate's displacement
  std::optional<End> velocity = {};
};

/// A fast side that integrates the surrogate of a slow one along with its own states, by reactive inputs (reaction.h). It
/// stands for both, and what both exchange within a step of the slow side stays inside. So one call takes it there.
///
/// Its ports are those of the fast side, then those of impulse_surrogate(), but for `force`, which are named
/// "surrogate.displacement" and so on. Inputs of the fast side that links drive are there, and have no effect.
///
/// - fast: has the ability `reactive_inputs`, and own steps of coupling.own_step.
/// - links: as those of the coupling.
/// Throws as impulse_surrogate(), and Error(invalid_argument) for another number of links and for a side without the ability.
std::unique_ptr<Subsystem> reactive_side(std::unique_ptr<Subsystem> fast, ImpulseCoupling coupling,
                                         std::vector<ReactiveLink> links, const std::string& surrogate);

}  // namespace tandem
