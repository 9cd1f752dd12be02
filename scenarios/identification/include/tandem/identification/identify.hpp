// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>

#include "tandem/identification/linear_model.hpp"
#include "tandem/subsystem.hpp"

namespace tandem::identification {

/// What a model has to tell.
struct Wanted {
  double start = 0.0;               ///< where it starts [s]
  std::vector<double> inputs = {};  ///< scalar inputs there, and after; all finite
  std::vector<int> values = {};     ///< of a sample row, that somebody reads
  std::int64_t steps = 12;          ///< own steps that the responses have at least, 12 to most_steps
};

/// A linear model of a subsystem from its inputs and outputs alone: eigensystem realization (J.-N. Juang, R. S. Pappa,
/// J. Guidance, Control and Dynamics 8, 1985).
///
/// The subsystem is started again and again. One run has the inputs as they are. In each of the others one input differs
/// over the first own step, by a polynomial that is 1 at one of `places` and 0 at the others, or at the start alone. The
/// differences are the responses that A, B and C have to give; the run itself tells e and y0. Responses are made twice
/// as long until order and residual stay, up to most_steps own steps.
///
/// Of a sampled subsystem the responses are what it gives at its first instants. Inputs differ at the first of these.
///
/// Where the subsystem is not linear, changes are small and the model is that about the motion of the first run.
///
/// Throws Error(not_supported) for a subsystem that can't start again, has an event on the way, takes own steps that vary,
/// or acts at instants that are not equally far apart.
LinearModel identify(Subsystem& subsystem, const Wanted& wanted);
/// The same, from one own step of each state where the subsystem tells these. Nothing where half a change of an input makes something else than half the response, by more than 1e-10.
std::optional<LinearModel> identify_linear(Subsystem& subsystem, const Wanted& wanted);
constexpr std::int64_t most_steps = 3072;
constexpr int most_states = 40;

}  // namespace tandem::identification
