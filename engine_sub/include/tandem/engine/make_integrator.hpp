// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "tandem/engine/integrators/adaptive.hpp"

namespace tandem::engine {

/// An integrator by its name, and its settings; those of what is not chosen must be as they are here.
struct IntegratorSettings {
  std::string name = "rk4";        ///< rk4, cvode_adams, cvode_bdf, erkstep, erkstep_fixed, arkstep
  bool locate_events = true;       ///< of rk4; if not, they are seen at the end of a step
  AdaptiveSettings adaptive = {};  ///< of the others
};

std::vector<std::string> integrator_names();
/// Throws Error for a name that is not there, and for a setting that is not allowed or not used.
std::unique_ptr<Integrator> make_integrator(const IntegratorSettings& settings);

}  // namespace tandem::engine
