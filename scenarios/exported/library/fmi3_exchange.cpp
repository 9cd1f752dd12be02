// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The functions of an FMU of version 3.0 for Model Exchange (Functional Mock-up Interface 3.0, chapter 3).
#include <cmath>

#include "fmi3.h"
#include "instance.hpp"

namespace {

template <class Work>
fmi3Status exchange(void* c, const Work& work) {
  return tandem::exported::exchange<fmi3Status>(c, work);
}
template <class Work>
fmi3Status evaluate(void* c, const Work& work) {
  return tandem::exported::evaluate<fmi3Status>(c, work);
}

}  // namespace

TANDEM_FMI fmi3Status fmi3EnterEventMode(fmi3Instance c) {
  return exchange(c, [](auto&) {});
}
TANDEM_FMI fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance c) {
  return exchange(c, [](auto&) {});
}
/// Once is enough. By the flag of states importers begin their integrators anew, which any event wants: rates
/// may have jumped.
TANDEM_FMI fmi3Status fmi3UpdateDiscreteStates(fmi3Instance c, bool* again, bool* terminate,
                                               bool* nominals_changed, bool* states_changed,
                                               bool* next_defined, double* next) {
  *again = *terminate = *nominals_changed = *states_changed = *next_defined = false;
  return exchange(c, [=](auto& unit) {
    *next = unit.event();
    *states_changed = unit.states_size() > 0;
    *next_defined = std::isfinite(*next);
  });
}
TANDEM_FMI fmi3Status fmi3CompletedIntegratorStep(fmi3Instance c, bool, bool* event, bool* terminate) {
  *event = *terminate = false;
  return exchange(c, [](auto& unit) { unit.step_done(); });
}
TANDEM_FMI fmi3Status fmi3SetTime(fmi3Instance c, double t) {
  return evaluate(c, [=](auto& unit) { unit.set_time(t); });
}
TANDEM_FMI fmi3Status fmi3SetContinuousStates(fmi3Instance c, const double x[], size_t n) {
  return evaluate(c, [=](auto& unit) { unit.set_states({x, n}); });
}
TANDEM_FMI fmi3Status fmi3GetContinuousStates(fmi3Instance c, double x[], size_t n) {
  return exchange(c, [=](auto& unit) { unit.get_states({x, n}); });
}
TANDEM_FMI fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance c, double dx[], size_t n) {
  return evaluate(c, [=](auto& unit) { unit.get_rates({dx, n}); });
}
TANDEM_FMI fmi3Status fmi3GetEventIndicators(fmi3Instance c, double z[], size_t n) {
  return evaluate(c, [=](auto& unit) { unit.get_indicators({z, n}); });
}
TANDEM_FMI fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance c, double to[], size_t n) {
  return exchange(c, [=](auto& unit) { unit.get_nominals({to, n}); });
}
TANDEM_FMI fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance c, size_t* to) {
  return exchange(c, [=](auto& unit) { *to = unit.states_size(); });
}
TANDEM_FMI fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance c, size_t* to) {
  return exchange(c, [=](auto& unit) { *to = unit.indicators_size(); });
}
