// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <optional>

#include "tandem/identification/linear_model.hpp"
#include "tandem/subsystem.hpp"

namespace tandem::identification {

/// A subsystem that is a linear model, with the ports of the one that the model was found from. Values of a row that the
/// model does not give are 0. It restarts, saves states, lands, and gives its states ("state 1"). Over a part of a step
/// it goes by the motion in continuous time that comes to the same whole steps; where there is none, a step that is cut is
/// Error(not_supported). Of a sampled subsystem it is sampled too, and takes set_states() at any time.
std::unique_ptr<Subsystem> make_surrogate(LinearModel model, const SubsystemInfo& of);

/// The model with another step: the same motion. Nothing where no step of it can be cut (PartSteps).
std::optional<LinearModel> with_step(const LinearModel& model, double step);

}  // namespace tandem::identification
