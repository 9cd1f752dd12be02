// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <vector>

#include "tandem/coordinator/topology.hpp"
#include "tandem/scenario/scenario.hpp"

namespace tandem::scenario {

/// Puts a surrogate between each slow side and the fast ones that [[links]] names: it stands as one more subsystem at the
/// end, and the connections of the links go through it. Its parameters are not known yet.
/// Precondition: `to` is read but for what comes after [coordination].
void couple_by_impulse(Scenario& to);

/// The parameters of a surrogate, from how its slow side and its fast ones start. Throws Error for sides that it can't
/// stand between.
/// - subsystem: of an instance.
std::vector<Parameter> parameters_of_surrogate(const ImpulseEntry& entry, const Scenario& of,
                                               const Topology& topology,
                                               const std::function<Subsystem&(int instance)>& subsystem);

}  // namespace tandem::scenario
