// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The functions of an FMU of version 2.0 for Model Exchange (FMI for Model Exchange and Co-Simulation 2.0,
// chapter 3).
#include <cmath>

#include "fmi2.h"
#include "instance.hpp"

namespace {

template <class Work>
fmi2Status exchange(void* c, const Work& work) {
  return tandem::exported::exchange<fmi2Status>(c, work);
}
template <class Work>
fmi2Status evaluate(void* c, const Work& work) {
  return tandem::exported::evaluate<fmi2Status>(c, work);
}

}  // namespace

TANDEM_FMI fmi2Status fmi2EnterEventMode(fmi2Component c) {
  return exchange(c, [](auto&) {});
}
TANDEM_FMI fmi2Status fmi2EnterContinuousTimeMode(fmi2Component c) {
  return exchange(c, [](auto&) {});
}
/// Once is enough. By the flag of states importers begin their integrators anew, which any event wants: rates
/// may have jumped.
TANDEM_FMI fmi2Status fmi2NewDiscreteStates(fmi2Component c, fmi2EventInfo* info) {
  return exchange(c, [=](auto& unit) {
    const double next = unit.event();
    *info = {};
    info->valuesOfContinuousStatesChanged = unit.states_size() > 0;
    info->nextEventTimeDefined = std::isfinite(next);
    info->nextEventTime = next;
  });
}
TANDEM_FMI fmi2Status fmi2CompletedIntegratorStep(fmi2Component c, fmi2Boolean, fmi2Boolean* event,
                                                  fmi2Boolean* terminate) {
  *event = *terminate = fmi2False;
  return exchange(c, [](auto& unit) { unit.step_done(); });
}
TANDEM_FMI fmi2Status fmi2SetTime(fmi2Component c, fmi2Real t) {
  return evaluate(c, [=](auto& unit) { unit.set_time(t); });
}
TANDEM_FMI fmi2Status fmi2SetContinuousStates(fmi2Component c, const fmi2Real x[], size_t n) {
  return evaluate(c, [=](auto& unit) { unit.set_states({x, n}); });
}
TANDEM_FMI fmi2Status fmi2GetContinuousStates(fmi2Component c, fmi2Real x[], size_t n) {
  return exchange(c, [=](auto& unit) { unit.get_states({x, n}); });
}
TANDEM_FMI fmi2Status fmi2GetDerivatives(fmi2Component c, fmi2Real dx[], size_t n) {
  return evaluate(c, [=](auto& unit) { unit.get_rates({dx, n}); });
}
TANDEM_FMI fmi2Status fmi2GetEventIndicators(fmi2Component c, fmi2Real z[], size_t n) {
  return evaluate(c, [=](auto& unit) { unit.get_indicators({z, n}); });
}
TANDEM_FMI fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component c, fmi2Real to[], size_t n) {
  return exchange(c, [=](auto& unit) { unit.get_nominals({to, n}); });
}
