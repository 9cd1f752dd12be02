// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The functions of an FMU of version 3.0 for Model Exchange (Functional Mock-up Interface 3.0, chapter 3).
#include <algorithm>
#include <cmath>

#include "fmi3.h"
#include "instance.hpp"

namespace {

template <class Work>
fmi3Status exchange(fmi3Instance c, const Work& work) {
  return tandem::exported::with<fmi3Status>(c, [&](tandem::exported::Instance& i) { work(i.exchanged()); });
}

}  // namespace

TANDEM_FMI fmi3Status fmi3EnterEventMode(fmi3Instance c) {
  return exchange(c, [](auto&) {});
}
TANDEM_FMI fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance c) {
  return exchange(c, [](auto&) {});
}
/// Once is enough.
TANDEM_FMI fmi3Status fmi3UpdateDiscreteStates(fmi3Instance c, bool* again, bool* terminate,
                                               bool* nominals_changed, bool* states_changed,
                                               bool* next_defined, double* next) {
  *again = *terminate = *nominals_changed = *states_changed = *next_defined = false;
  return exchange(c, [=](auto& unit) {
    const auto event = unit.event();
    *states_changed = event.sets_states;
    *next_defined = std::isfinite(event.next);
    *next = event.next;
  });
}
TANDEM_FMI fmi3Status fmi3CompletedIntegratorStep(fmi3Instance c, bool, bool* event, bool* terminate) {
  *event = *terminate = false;
  return exchange(c, [](auto& unit) { unit.step_done(); });
}
TANDEM_FMI fmi3Status fmi3SetTime(fmi3Instance c, double t) {
  return exchange(c, [=](auto& unit) { unit.set_time(t); });
}
TANDEM_FMI fmi3Status fmi3SetContinuousStates(fmi3Instance c, const double x[], size_t n) {
  return exchange(c, [=](auto& unit) { unit.set_states({x, n}); });
}
TANDEM_FMI fmi3Status fmi3GetContinuousStates(fmi3Instance c, double x[], size_t n) {
  return exchange(c, [=](auto& unit) { unit.get_states({x, n}); });
}
TANDEM_FMI fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance c, double dx[], size_t n) {
  return exchange(c, [=](auto& unit) { unit.get_rates({dx, n}); });
}
TANDEM_FMI fmi3Status fmi3GetEventIndicators(fmi3Instance c, double z[], size_t n) {
  return exchange(c, [=](auto& unit) { unit.get_indicators({z, n}); });
}
/// A diagram says none.
TANDEM_FMI fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance c, double to[], size_t n) {
  return exchange(c, [=](auto&) { std::fill_n(to, n, 1.0); });
}
TANDEM_FMI fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance c, size_t* to) {
  return exchange(c, [=](auto& unit) { *to = unit.states_size(); });
}
TANDEM_FMI fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance c, size_t* to) {
  return exchange(c, [=](auto& unit) { *to = unit.indicators_size(); });
}
