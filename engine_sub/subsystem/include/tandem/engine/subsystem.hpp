// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "tandem/engine/description.hpp"
#include "tandem/engine/make_integrator.hpp"
#include "tandem/engine/simulation.hpp"
#include "tandem/subsystem.hpp"

namespace tandem::engine {

struct SubsystemSettings {
  double step = 0.0;  ///< own step [s]; 0 for a diagram that is sampled
  IntegratorSettings integrator = {};
  SimulationSettings simulation = {};
};

/// A diagram that integrates itself with a fixed own step. Inputs are read wherever the integrator evaluates.
/// Feedthrough is what the diagram says. An output that is a state comes with its derivative by time; one
/// that follows held values alone is held; one that an event makes jump comes with both rows there (ability
/// `events`). A diagram whose outputs change at its blocks' periodic instants alone, and that has no states,
/// is a sampled subsystem, which acts at the union of these instants. It remarks data that end before the run
/// does and are not held, and tells what its integrator has done. Throws Error for a step that is not finite
/// and above 0, or is given to a sampled one, and for what compile() and make_integrator() refuse.
std::unique_ptr<Subsystem> make_subsystem(const Description& diagram, const SubsystemSettings& settings);

}  // namespace tandem::engine
