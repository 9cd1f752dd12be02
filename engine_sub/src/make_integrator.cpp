// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/engine/make_integrator.hpp"

#include "tandem/engine/integrators/runge_kutta.hpp"
#include "tandem/error.hpp"
#include "tandem/nearest.hpp"

namespace tandem::engine {
namespace {

struct Entry {
  const char* name;
  std::unique_ptr<Integrator> (*make)(const AdaptiveSettings&);
};
constexpr Entry adaptive[] = {{"cvode_adams", cvode_adams},
                              {"cvode_bdf", cvode_bdf},
                              {"erkstep", erkstep},
                              {"erkstep_fixed", erkstep_fixed},
                              {"arkstep", arkstep}};

[[noreturn]] void refuse(const std::string& sentence) { throw Error(ErrorCode::invalid_argument, sentence); }

}  // namespace

std::vector<std::string> integrator_names() {
  std::vector<std::string> names = {"rk4"};
  for (const Entry& entry : adaptive) names.push_back(entry.name);
  return names;
}

std::unique_ptr<Integrator> make_integrator(const IntegratorSettings& settings) {
  const bool has_fixed_steps = settings.name == "rk4" || settings.name == "erkstep_fixed";
  if (has_fixed_steps && settings.adaptive != AdaptiveSettings{})
    refuse("tolerances and limits of an adaptive integrator are given, but " + settings.name +
           " is chosen; allowed is to leave them out");
  if (settings.name == "rk4") {
    return std::make_unique<RungeKutta4>(settings.locate_events);
  }
  for (const Entry& entry : adaptive)
    if (settings.name == entry.name) {
      if (!settings.locate_events)
        refuse("locate_events is false, but " + settings.name +
               " always locates them; allowed is true, or rk4");
      return entry.make(settings.adaptive);
    }
  refuse(unknown("integrator", settings.name, integrator_names()));
}

}  // namespace tandem::engine
