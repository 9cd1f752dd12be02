// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "tandem/engine/integrators/integrator.hpp"

namespace tandem::engine {

struct IntegratorSettings {
  std::string name = "rk4";
  bool locate_events = true;  ///< of rk4; if not, they are seen at the end of a step
};

std::vector<std::string> integrator_names();
/// Throws Error for a name that is not there and a setting that is not allowed.
std::unique_ptr<Integrator> make_integrator(const IntegratorSettings& settings);

}  // namespace tandem::engine
