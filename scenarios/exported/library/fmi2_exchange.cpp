// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The functions of an FMU of version 2.0 for Model Exchange (FMI for Model Exchange and Co-Simulation 2.0, chapter 3).
#include <algorithm>
#include <cmath>

#include "fmi2.h"
#include "instance.hpp"

namespace {

template <class Work>
fmi2Status exchange(fmi2Component c, const Work& work) {
  return tandem::exported::with<fmi2Status>(c, [&](tandem::exported::Instance& i) { work(i.exchanged()); });
}

}  // namespace

TANDEM_FMI fmi2Status fmi2EnterEventMode(fmi2Component c) {
  return exchange(c, [](auto&) {});
}
TANDEM_FMI fmi2Status fmi2EnterContinuousTimeMode(fmi2Component c) {
  return exchange(c, [](auto&) {});
}
/// Once is enough.
TANDEM_FMI fmi2Status fmi2NewDiscreteStates(fmi2Component c, fmi2EventInfo* info) {
  return exchange(c, [=](auto& unit) {
    const auto event = unit.event();
    *info = {};
    info->valuesOfContinuousStatesChanged = event.sets_states;
    info->nextEventTimeDefined = std::isfinite(event.next);
    info->nextEventTime = event.next;
  });
}
TANDEM_FMI fmi2Status fmi2CompletedIntegratorStep(fmi2Component c, fmi2Boolean, fmi2Boolean* event,
                                                  fmi2Boolean* terminate) {
  *event = *terminate = fmi2False;
  return exchange(c, [](auto& unit) { unit.step_done(); });
}
TANDEM_FMI fmi2Status fmi2SetTime(fmi2Component c, fmi2Real t) {
  return exchange(c, [=](auto& unit) { unit.set_time(t); });
}
TANDEM_FMI fmi2Status fmi2SetContinuousStates(fmi2Component c, const fmi2Real x[], size_t n) {
  return exchange(c, [=](auto& unit) { unit.set_states({x, n}); });
}
TANDEM_FMI fmi2Status fmi2GetContinuousStates(fmi2Component c, fmi2Real x[], size_t n) {
  return exchange(c, [=](auto& unit) { unit.get_states({x, n}); });
}
TANDEM_FMI fmi2Status fmi2GetDerivatives(fmi2Component c, fmi2Real dx[], size_t n) {
  return exchange(c, [=](auto& unit) { unit.get_rates({dx, n}); });
}
TANDEM_FMI fmi2Status fmi2GetEventIndicators(fmi2Component c, fmi2Real z[], size_t n) {
  return exchange(c, [=](auto& unit) { unit.get_indicators({z, n}); });
}
/// A diagram says none.
TANDEM_FMI fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component c, fmi2Real to[], size_t n) {
  return exchange(c, [=](auto&) { std::fill_n(to, n, 1.0); });
}
