// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/engine/make_integrator.hpp"

#include "tandem/engine/integrators/runge_kutta.hpp"
#include "tandem/error.hpp"
#include "tandem/nearest.hpp"

namespace tandem::engine {

std::vector<std::string> integrator_names() { return {"rk4"}; }

std::unique_ptr<Integrator> make_integrator(const IntegratorSettings& settings) {
  if (settings.name == "rk4") return std::make_unique<RungeKutta4>(settings.locate_events);
  throw Error(ErrorCode::invalid_argument, unknown("integrator", settings.name, integrator_names()));
}

}  // namespace tandem::engine
