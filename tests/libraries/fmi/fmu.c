/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
#include "fmu.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fmi2.h"

#define EXPORT __attribute__((visibility("default")))

typedef struct {
  fmu_values values;
  fmi2CallbackFunctions callbacks;
  fmi2Type type;
  double steps_taken; /* of Co-Simulation, since the start */
  double start, stop;
  int in_events;
} instance;

static fmi2Status fail(instance* m, fmi2Status status, const char* why, unsigned int reference) {
  m->callbacks.logger(m->callbacks.componentEnvironment, "", status, "error", why, reference);
  return status;
}

EXPORT const char* fmi2GetVersion(void) { return "2.0"; }

EXPORT fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                                     const fmi2CallbackFunctions* callbacks, fmi2Boolean visible,
                                     fmi2Boolean logging) {
  instance* const m = calloc(1, sizeof(instance));
  (void)name, (void)visible, (void)logging;
  if (!m) return NULL;
  m->callbacks = *callbacks;
  m->type = type;
  if (strcmp(guid, model.guid) != 0 || strncmp(resources, "file:///", 8) != 0) {
    fail(m, fmi2Error, "the guid or the folder of resources is wrong", 0);
    free(m);
    return NULL;
  }
  set_start(&m->values);
  return m;
}
EXPORT void fmi2FreeInstance(fmi2Component c) { free(c); }

EXPORT fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean tolerance_defined, fmi2Real tolerance,
                                      fmi2Real start, fmi2Boolean stop_defined, fmi2Real stop) {
  instance* const m = c;
  (void)tolerance_defined, (void)tolerance;
  m->start = m->values.v[0] = start;
  m->stop = stop_defined ? stop : INFINITY;
  m->steps_taken = 0;
  return fmi2OK;
}
EXPORT fmi2Status fmi2EnterInitializationMode(fmi2Component c) {
  compute(&((instance*)c)->values);
  return fmi2OK;
}
EXPORT fmi2Status fmi2ExitInitializationMode(fmi2Component c) {
  instance* const m = c;
  compute(&m->values);
  m->in_events = m->type == fmi2ModelExchange;
  return fmi2OK;
}
EXPORT fmi2Status fmi2Terminate(fmi2Component c) {
  (void)c;
  return fmi2OK;
}
EXPORT fmi2Status fmi2Reset(fmi2Component c) {
  instance* const m = c;
  memset(&m->values, 0, sizeof m->values);
  set_start(&m->values);
  return fmi2OK;
}

/* References of reals are those of v, of all others those of w; of a string 0. */
#define ACCESS(Name, Type, array, most, copy)                                                            \
  EXPORT fmi2Status fmi2##Name(fmi2Component c, const fmi2ValueReference r[], size_t n, Type values[]) { \
    instance* const m = c;                                                                               \
    size_t k;                                                                                            \
    for (k = 0; k < n; ++k) {                                                                            \
      if (r[k] >= most) return fail(m, fmi2Error, "no variable has the reference %u", r[k]);             \
      copy;                                                                                              \
    }                                                                                                    \
    return fmi2OK;                                                                                       \
  }
#define GET compute(&m->values), values[k] =
ACCESS(GetReal, fmi2Real, v, most_reals, GET m->values.v[r[k]])
ACCESS(GetInteger, fmi2Integer, w, most_wholes, GET m->values.w[r[k]])
ACCESS(GetBoolean, fmi2Boolean, w, most_wholes, GET m->values.w[r[k]])
ACCESS(SetReal, const fmi2Real, v, most_reals, m->values.v[r[k]] = values[k];
       m->values.input_rates[r[k]][0] = m->values.input_rates[r[k]][1] = 0)
ACCESS(SetInteger, const fmi2Integer, w, most_wholes, m->values.w[r[k]] = values[k])
ACCESS(SetBoolean, const fmi2Boolean, w, most_wholes, m->values.w[r[k]] = values[k])
ACCESS(SetString, const fmi2String, text, 1, snprintf(m->values.text, sizeof m->values.text, "%s", values[k]))

EXPORT fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate* state) {
  if (!*state) *state = malloc(sizeof(instance));
  memcpy(*state, c, sizeof(instance));
  return fmi2OK;
}
EXPORT fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state) {
  memcpy(c, state, sizeof(instance));
  return fmi2OK;
}
EXPORT fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate* state) {
  (void)c;
  free(*state);
  *state = NULL;
  return fmi2OK;
}
EXPORT fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate state, size_t* size) {
  (void)c, (void)state;
  *size = sizeof(fmu_values) + 3 * sizeof(double);
  return fmi2OK;
}
EXPORT fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[], size_t size) {
  const instance* const m = state;
  const double numbers[] = {m->steps_taken, m->start, m->stop};
  (void)c;
  if (size < sizeof m->values + sizeof numbers) return fmi2Error;
  memcpy(bytes, &m->values, sizeof m->values);
  memcpy(bytes + sizeof m->values, numbers, sizeof numbers);
  return fmi2OK;
}
EXPORT fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte bytes[], size_t size,
                                          fmi2FMUstate* state) {
  instance* m;
  double numbers[3];
  if (size != sizeof(fmu_values) + sizeof numbers)
    return fail(c, fmi2Error, "the bytes are not those of a state", 0);
  fmi2GetFMUstate(c, state);
  m = *state;
  memcpy(&m->values, bytes, sizeof m->values);
  memcpy(numbers, bytes + sizeof m->values, sizeof numbers);
  m->steps_taken = numbers[0], m->start = numbers[1], m->stop = numbers[2];
  return fmi2OK;
}

/* Model Exchange */

EXPORT fmi2Status fmi2EnterEventMode(fmi2Component c) {
  ((instance*)c)->in_events = 1;
  return fmi2OK;
}
EXPORT fmi2Status fmi2NewDiscreteStates(fmi2Component c, fmi2EventInfo* info) {
  instance* const m = c;
  compute(&m->values);
  info->newDiscreteStatesNeeded = fmi2False;
  info->valuesOfContinuousStatesChanged = act(&m->values) ? fmi2True : fmi2False;
  info->terminateSimulation = m->values.ended ? fmi2True : fmi2False;
  info->nominalsOfContinuousStatesChanged = fmi2False;
  info->nextEventTimeDefined = isfinite(m->values.next_event) ? fmi2True : fmi2False;
  info->nextEventTime = m->values.next_event;
  return fmi2OK;
}
EXPORT fmi2Status fmi2EnterContinuousTimeMode(fmi2Component c) {
  ((instance*)c)->in_events = 0;
  return fmi2OK;
}
EXPORT fmi2Status fmi2CompletedIntegratorStep(fmi2Component c, fmi2Boolean never_back, fmi2Boolean* event,
                                              fmi2Boolean* end) {
  (void)c, (void)never_back;
  *event = *end = fmi2False;
  return fmi2OK;
}
EXPORT fmi2Status fmi2SetTime(fmi2Component c, fmi2Real t) {
  ((instance*)c)->values.v[0] = t;
  return fmi2OK;
}
EXPORT fmi2Status fmi2SetContinuousStates(fmi2Component c, const fmi2Real x[], size_t n) {
  size_t k;
  for (k = 0; k < n; ++k) ((instance*)c)->values.v[model.state[k]] = x[k];
  return fmi2OK;
}
EXPORT fmi2Status fmi2GetContinuousStates(fmi2Component c, fmi2Real x[], size_t n) {
  size_t k;
  for (k = 0; k < n; ++k) x[k] = ((instance*)c)->values.v[model.state[k]];
  return fmi2OK;
}
EXPORT fmi2Status fmi2GetDerivatives(fmi2Component c, fmi2Real dx[], size_t n) {
  size_t k;
  compute(&((instance*)c)->values);
  for (k = 0; k < n; ++k) dx[k] = ((instance*)c)->values.v[model.rate[k]];
  return fmi2OK;
}
/* By central differences of length 1, which are right for polynomials of degree 2. */
EXPORT fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference unknown[], size_t nu,
                                               const fmi2ValueReference known[], size_t nk,
                                               const fmi2Real seed[], fmi2Real found[]) {
  fmu_values forth = ((instance*)c)->values, back = forth;
  size_t k;
  for (k = 0; k < nk; ++k) forth.v[known[k]] += seed[k], back.v[known[k]] -= seed[k];
  compute(&forth), compute(&back);
  for (k = 0; k < nu; ++k) found[k] = (forth.v[unknown[k]] - back.v[unknown[k]]) / 2;
  return fmi2OK;
}
EXPORT fmi2Status fmi2GetEventIndicators(fmi2Component c, fmi2Real z[], size_t n) {
  (void)n;
  compute(&((instance*)c)->values);
  read_indicators(&((instance*)c)->values, z);
  return fmi2OK;
}

/* Co-Simulation */

EXPORT fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference r[], size_t n,
                                              const fmi2Integer order[], const fmi2Real values[]) {
  size_t k;
  for (k = 0; k < n; ++k) {
    if (r[k] >= most_reals || order[k] < 1 || order[k] > 2) return fmi2Error;
    ((instance*)c)->values.input_rates[r[k]][order[k] - 1] = values[k];
  }
  return fmi2OK;
}

/* Of states alone. */
EXPORT fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference r[], size_t n,
                                               const fmi2Integer orders[], fmi2Real values[]) {
  size_t k;
  for (k = 0; k < n; ++k)
    if (!derive_state(&((instance*)c)->values, r[k], orders[k], values + k))
      return fail(c, fmi2Error, "no derivative is known of the reference %u", r[k]);
  return fmi2OK;
}

EXPORT fmi2Status fmi2DoStep(fmi2Component c, fmi2Real t, fmi2Real h, fmi2Boolean never_back) {
  instance* const m = c;
  (void)never_back;
  if (t + h > m->stop + 1e-9) return fail(m, fmi2Error, "the step ends beyond the stop time", 0);
  if (model.fixed_step == 0) {
    take_step(&m->values, t, h, NULL, NULL);
  } else {
    while (m->start + (m->steps_taken + 1) * model.fixed_step <= t + h + 1e-9) {
      take_step(&m->values, m->start + m->steps_taken * model.fixed_step, model.fixed_step, NULL, NULL);
      ++m->steps_taken;
    }
  }
  act(&m->values);
  return m->values.ended ? fail(m, fmi2Discard, "#r0# is at its end, ##", 0) : fmi2OK;
}
EXPORT fmi2Status fmi2GetRealStatus(fmi2Component c, fmi2StatusKind kind, fmi2Real* value) {
  *value = ((instance*)c)->values.v[0];
  return kind == fmi2LastSuccessfulTime ? fmi2OK : fmi2Discard;
}
EXPORT fmi2Status fmi2GetBooleanStatus(fmi2Component c, fmi2StatusKind kind, fmi2Boolean* value) {
  *value = ((instance*)c)->values.ended == 1 ? fmi2True : fmi2False;
  return kind == fmi2Terminated ? fmi2OK : fmi2Discard;
}
