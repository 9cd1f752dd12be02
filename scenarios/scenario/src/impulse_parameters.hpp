// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>

#include "tandem/coordinator/impulse/impulse_surrogate.hpp"
#include "tandem/coordinator/topology.hpp"
#include "tandem/scenario/scenario.hpp"

namespace tandem::scenario {

/// What an impulse surrogate goes by, from how its slow side and its fast ones start. Throws Error for sides that it can't
/// stand between.
/// - subsystem: of the instances that the entry names.
ImpulseCoupling impulse_coupling(const ImpulseEntry& entry, const Scenario& of, const Topology& topology,
                                 const std::function<Subsystem&(int)>& subsystem);

/// The shortest own step of the fast sides [s].
double fast_step(const ImpulseEntry& entry, const Scenario& of, const Topology& topology,
                 const std::function<Subsystem&(int)>& subsystem);

}  // namespace tandem::scenario
