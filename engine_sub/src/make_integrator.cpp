// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/engine/make_integrator.hpp"

#include "tandem/engine/integrators/runge_kutta.hpp"
#include "tandem/error.hpp"
#include "tandem/nearest.hpp"

namespace tandem::engine {

std::vector<std::string> integrator_names() {
  std::vector<std::string> names = adaptive_names();
  names.insert(names.begin(), "rk4");
  return names;
}

std::unique_ptr<Integrator> make_integrator(const IntegratorSettings& settings) {
  if (settings.name == "rk4") {
    refuse_settings(settings.name, settings.adaptive);
    return std::make_unique<RungeKutta4>(settings.locate_events);
  }
  auto integrator = adaptive_integrator_of_diagrams(settings.name, settings.adaptive);
  if (!integrator)
    throw Error(ErrorCode::invalid_argument, unknown("integrator", settings.name, integrator_names()));
  if (!settings.locate_events)
    throw Error(ErrorCode::invalid_argument, "locate_events is false, but " + settings.name +
                                                 " always locates them; allowed is true, or rk4");
  return integrator;
}

}  // namespace tandem::engine
