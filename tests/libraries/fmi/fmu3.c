/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* All of FMI 3.0 that is called, one function after the other, and long for that. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fmi3.h"
#include "fmu.h"

#define EXPORT __attribute__((visibility("default")))
#define REFERENCES const fmi3ValueReference r[], size_t n

typedef struct {
  fmu_values values;
  fmi3InstanceEnvironment environment;
  fmi3LogMessageCallback log;
  fmi3IntermediateUpdateCallback within_step;
  int exchanges, event_mode, early_return;
  enum { instantiated, configuring, initializing, in_events, running } mode;
  double steps_taken; /* of Co-Simulation, since the start */
  double start, stop;
  double above[most_indicators];
} instance;

static fmi3Status fail(instance* m, const char* why) {
  m->log(m->environment, fmi3Error, NULL, why);
  return fmi3Error;
}
static int size_of(const instance* m, fmi3ValueReference r) {
  return model.size ? model.size(&m->values, r) : 1;
}
static int states_of(const instance* m) {
  return model.size ? model.size(&m->values, (unsigned)model.state[0]) : model.states;
}

EXPORT const char* fmi3GetVersion(void) { return "3.0"; }

static instance* make(fmi3String token, fmi3String resources, fmi3InstanceEnvironment environment,
                      fmi3LogMessageCallback log) {
  instance* const m = calloc(1, sizeof(instance));
  if (!m) return NULL;
  m->environment = environment, m->log = log;
  if (strcmp(token, model.guid) != 0 || (resources && resources[strlen(resources) - 1] != '/')) {
    fail(m, "the token or the folder of resources is wrong");
    free(m);
    return NULL;
  }
  set_start(&m->values);
  return m;
}
EXPORT fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String resources,
                                                 bool visible, bool logging,
                                                 fmi3InstanceEnvironment environment,
                                                 fmi3LogMessageCallback log) {
  instance* const m = make(token, resources, environment, log);
  (void)name, (void)visible, (void)logging;
  if (m) m->exchanges = 1;
  return m;
}
EXPORT fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resources,
                                                bool visible, bool logging, bool event_mode,
                                                bool early_return, const fmi3ValueReference intermediate[],
                                                size_t n, fmi3InstanceEnvironment environment,
                                                fmi3LogMessageCallback log,
                                                fmi3IntermediateUpdateCallback within_step) {
  instance* const m = make(token, resources, environment, log);
  (void)name, (void)visible, (void)logging, (void)intermediate, (void)n;
  if (m) m->event_mode = event_mode, m->early_return = early_return, m->within_step = within_step;
  return m;
}
EXPORT void fmi3FreeInstance(fmi3Instance c) { free(c); }

static fmi3Status to(fmi3Instance c, int from, int mode) {
  instance* const m = c;
  if ((int)m->mode != from) return fail(m, "a function was called in a wrong mode");
  m->mode = mode;
  return fmi3OK;
}
EXPORT fmi3Status fmi3EnterConfigurationMode(fmi3Instance c) { return to(c, instantiated, configuring); }
EXPORT fmi3Status fmi3ExitConfigurationMode(fmi3Instance c) { return to(c, configuring, instantiated); }
EXPORT fmi3Status fmi3EnterInitializationMode(fmi3Instance c, bool tolerance_defined, double tolerance,
                                              double start, bool stop_defined, double stop) {
  instance* const m = c;
  (void)tolerance_defined, (void)tolerance;
  m->start = m->values.v[0] = start;
  m->stop = stop_defined ? stop : INFINITY;
  m->steps_taken = 0;
  compute(&m->values);
  return to(c, instantiated, initializing);
}
static void note_indicators(instance* m) {
  int k;
  read_indicators(&m->values, m->above);
  for (k = 0; k < most_indicators; ++k) m->above[k] = m->above[k] > 0;
}
EXPORT fmi3Status fmi3ExitInitializationMode(fmi3Instance c) {
  instance* const m = c;
  compute(&m->values);
  note_indicators(m);
  if (!m->exchanges && !m->event_mode) act(&m->values);
  return to(c, initializing, m->exchanges || m->event_mode ? in_events : running);
}
EXPORT fmi3Status fmi3Terminate(fmi3Instance c) {
  (void)c;
  return fmi3OK;
}
EXPORT fmi3Status fmi3Reset(fmi3Instance c) {
  instance* const m = c;
  memset(&m->values, 0, sizeof m->values);
  set_start(&m->values);
  m->mode = instantiated;
  return fmi3OK;
}

/* References of floats are those of v, of whole numbers those of w and 10 more; of the text 20. */
#define ACCESS(Name, type, array, first, most, copy)                                                    \
  EXPORT fmi3Status fmi3##Name(fmi3Instance c, REFERENCES, type values[], size_t count) {               \
    instance* const m = c;                                                                              \
    size_t k, at = 0;                                                                                   \
    int i;                                                                                              \
    for (k = 0; k < n; ++k)                                                                             \
      for (i = 0; i < size_of(m, r[k]); ++i, ++at) {                                                    \
        const size_t place = r[k] - first + (size_t)i;                                                  \
        if (place >= most || at >= count) return fail(m, "a reference or a number of values is wrong"); \
        copy;                                                                                           \
      }                                                                                                 \
    return at == count ? fmi3OK : fail(m, "a number of values is wrong");                               \
  }
#define BOTH(Name, type, own, array, first, most)                          \
  ACCESS(Get##Name, type, array, first, most,                              \
         (compute(&m->values), values[at] = (type)m->values.array[place])) \
  ACCESS(Set##Name, const type, array, first, most, m->values.array[place] = (own)values[at])
BOTH(Float64, double, double, v, 0, most_reals)
BOTH(Float32, float, double, v, 0, most_reals)
BOTH(Int8, int8_t, int, w, 10, most_wholes)
BOTH(UInt8, uint8_t, int, w, 10, most_wholes)
BOTH(Int16, int16_t, int, w, 10, most_wholes)
BOTH(UInt16, uint16_t, int, w, 10, most_wholes)
BOTH(Int32, int32_t, int, w, 10, most_wholes)
BOTH(UInt32, uint32_t, int, w, 10, most_wholes)
BOTH(Int64, int64_t, int, w, 10, most_wholes)
BOTH(UInt64, uint64_t, int, w, 10, most_wholes)
BOTH(Boolean, bool, int, w, 10, most_wholes)
ACCESS(SetString, const fmi3String, text, 20, 1,
       snprintf(m->values.text, sizeof m->values.text, "%s", values[at]))

EXPORT fmi3Status fmi3GetFMUState(fmi3Instance c, fmi3FMUState* state) {
  if (!*state) *state = malloc(sizeof(instance));
  memcpy(*state, c, sizeof(instance));
  return fmi3OK;
}
EXPORT fmi3Status fmi3SetFMUState(fmi3Instance c, fmi3FMUState state) {
  memcpy(c, state, sizeof(instance));
  return fmi3OK;
}
EXPORT fmi3Status fmi3FreeFMUState(fmi3Instance c, fmi3FMUState* state) {
  (void)c;
  free(*state);
  *state = NULL;
  return fmi3OK;
}
/* Without what belongs to the process. */
EXPORT fmi3Status fmi3SerializedFMUStateSize(fmi3Instance c, fmi3FMUState state, size_t* size) {
  (void)c, (void)state;
  *size = sizeof(instance);
  return fmi3OK;
}
EXPORT fmi3Status fmi3SerializeFMUState(fmi3Instance c, fmi3FMUState state, uint8_t bytes[], size_t size) {
  instance copy = *(instance*)state;
  if (size < sizeof copy) return fail(c, "there is no room for the state");
  copy.environment = NULL, copy.log = NULL, copy.within_step = NULL;
  memcpy(bytes, &copy, sizeof copy);
  return fmi3OK;
}
EXPORT fmi3Status fmi3DeserializeFMUState(fmi3Instance c, const uint8_t bytes[], size_t size,
                                          fmi3FMUState* state) {
  const instance* const own = c;
  instance* m;
  if (size != sizeof(instance)) return fail(c, "the bytes are not those of a state");
  fmi3GetFMUState(c, state);
  m = *state;
  memcpy(m, bytes, sizeof *m);
  m->environment = own->environment, m->log = own->log, m->within_step = own->within_step;
  return fmi3OK;
}

EXPORT fmi3Status fmi3EnterEventMode(fmi3Instance c) { return to(c, running, in_events); }
EXPORT fmi3Status fmi3EnterStepMode(fmi3Instance c) { return to(c, in_events, running); }
EXPORT fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance c) { return to(c, in_events, running); }
EXPORT fmi3Status fmi3UpdateDiscreteStates(fmi3Instance c, bool* again, bool* terminate,
                                           bool* nominals_changed, bool* states_changed,
                                           bool* next_event_defined, double* next_event) {
  instance* const m = c;
  if (m->mode != in_events) return fail(m, "discrete states are updated in event mode");
  compute(&m->values);
  *again = *nominals_changed = false;
  *states_changed = act(&m->values) != 0;
  *terminate = m->values.ended != 0;
  *next_event_defined = isfinite(m->values.next_event);
  *next_event = m->values.next_event;
  note_indicators(m);
  return fmi3OK;
}

/* Model Exchange */

EXPORT fmi3Status fmi3CompletedIntegratorStep(fmi3Instance c, bool never_back, bool* event, bool* end) {
  (void)c, (void)never_back;
  *event = *end = false;
  return fmi3OK;
}
EXPORT fmi3Status fmi3SetTime(fmi3Instance c, double t) {
  ((instance*)c)->values.v[0] = t;
  return fmi3OK;
}
static fmi3Status move_states(instance* m, double x[], size_t n, const int* variables, int set) {
  size_t k;
  if (n != (size_t)states_of(m)) return fail(m, "the number of states is wrong");
  compute(&m->values);
  for (k = 0; k < n; ++k)
    if (set)
      m->values.v[variables[k]] = x[k];
    else
      x[k] = m->values.v[variables[k]];
  return fmi3OK;
}
EXPORT fmi3Status fmi3SetContinuousStates(fmi3Instance c, const double x[], size_t n) {
  return move_states(c, (double*)x, n, model.state, 1);
}
EXPORT fmi3Status fmi3GetContinuousStates(fmi3Instance c, double x[], size_t n) {
  return move_states(c, x, n, model.state, 0);
}
EXPORT fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance c, double dx[], size_t n) {
  return move_states(c, dx, n, model.rate, 0);
}
/* By central differences of length 1, which are right for polynomials of degree 2. Of scalars. */
EXPORT fmi3Status fmi3GetDirectionalDerivative(fmi3Instance c, const fmi3ValueReference unknown[], size_t nu,
                                               const fmi3ValueReference known[], size_t nk,
                                               const double seed[], size_t seeds, double found[],
                                               size_t wanted) {
  fmu_values forth = ((instance*)c)->values, back = forth;
  size_t k;
  if (seeds != nk || wanted != nu) return fail(c, "the number of directional derivatives is wrong");
  for (k = 0; k < nk; ++k) forth.v[known[k]] += seed[k], back.v[known[k]] -= seed[k];
  compute(&forth), compute(&back);
  for (k = 0; k < nu; ++k) found[k] = (forth.v[unknown[k]] - back.v[unknown[k]]) / 2;
  return fmi3OK;
}
EXPORT fmi3Status fmi3GetEventIndicators(fmi3Instance c, double z[], size_t n) {
  if (n != (size_t)model.indicators) return fail(c, "the number of event indicators is wrong");
  compute(&((instance*)c)->values);
  read_indicators(&((instance*)c)->values, z);
  return fmi3OK;
}

/* Co-Simulation */

static void ask_for_inputs(void* c, double t) {
  instance* const m = c;
  bool early;
  double when;
  if (m->within_step) m->within_step(m->environment, t, true, false, false, false, &early, &when);
}

/* Whether an indicator has another sign, or the time of an event has come. */
static int has_event(instance* m) {
  double z[most_indicators] = {0};
  int k, event = m->values.v[0] >= m->values.next_event - 1e-9;
  read_indicators(&m->values, z);
  for (k = 0; k < model.indicators; ++k) event = event || (z[k] > 0) != (m->above[k] > 0);
  return event;
}

/* Of states alone. */
EXPORT fmi3Status fmi3GetOutputDerivatives(fmi3Instance c, const fmi3ValueReference r[], size_t n,
                                           const int32_t orders[], double values[], size_t wanted) {
  size_t k;
  if (wanted != n) return fail(c, "the number of derivatives of outputs is wrong");
  for (k = 0; k < n; ++k)
    if (!derive_state(&((instance*)c)->values, r[k], orders[k], values + k))
      return fail(c, "no derivative of that order is known");
  return fmi3OK;
}

/* Without an event mode it handles events itself. With one it returns at them, or at the end of the step. */
EXPORT fmi3Status fmi3DoStep(fmi3Instance c, double t, double h, bool never_back, bool* event_needed,
                             bool* terminate, bool* early_return, double* reached) {
  instance* const m = c;
  double own = model.fixed_step > 0 ? model.fixed_step : h;
  (void)never_back;
  if (m->mode != running) return fail(m, "a step is taken in step mode");
  if (t + h > m->stop + 1e-9) return fail(m, "the step ends beyond the stop time");
  *event_needed = *early_return = false;
  while (m->values.v[0] + own <= t + h + 1e-9) {
    const double begin = model.fixed_step > 0 ? m->start + m->steps_taken * own : t;
    take_step(&m->values, begin, own, ask_for_inputs, m);
    ++m->steps_taken;
    if (!has_event(m)) continue;
    if (!m->event_mode) act(&m->values), note_indicators(m);
    *event_needed = m->event_mode;
    if (m->early_return || m->values.ended) break;
  }
  *early_return = m->early_return && m->values.v[0] + own <= t + h + 1e-9;
  *terminate = m->values.ended != 0;
  *reached = m->values.v[0];
  return fmi3OK;
}
