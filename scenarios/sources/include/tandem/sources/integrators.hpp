// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "tandem/engine/integrators/adaptive.hpp"
#include "tandem/transports/parameters.hpp"

namespace tandem {

/// `integrator`, and settings of those of SUNDIALS. A client of a server may set them.
Words integrator_words();

/// The settings among the parameters, in place of what stands there. Throws Error for a value that is not
/// allowed.
void take_adaptive(Parameters& parameters, engine::AdaptiveSettings& settings);

/// The one of SUNDIALS that `integrator` names, with its settings; null: it names none, or rk4.
std::unique_ptr<AdaptiveIntegrator> take_integrator(Parameters& parameters);

}  // namespace tandem
