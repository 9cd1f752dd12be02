/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* A relay in C99, as a shared library: a subsystem with events. Its output F [N] is held: `off` at the start;
 * `on` from where its input x [m] rises above `high`, `off` from where it falls below `low`. */
#include "tandem/fixed_step.h"

enum { high, low, on, off, h, parameter_count };
static const tandem_parameter parameters[parameter_count] = {
    {"high", "m", NULL, "it switches on above"},
    {"low", "m", NULL, "it switches off below"},
    {"on", "N", NULL, "output when it is on"},
    {"off", "N", NULL, "output when it is off"},
    {"h", "s", NULL, "own step, at whose ends x is looked at"},
};

static const tandem_port inputs[] = {{"x", "m", 1, 0, NAN}};
static const tandem_port outputs[] = {{"F", "N", 1, 0, NAN}};
static const int32_t held[] = {1};

/* The state is an int: whether it is on. */
static int* is_on(const tandem_instance* self) { return self->state; }

static double own_step(const tandem_instance* self) { return self->p[h]; }

/* Off where x is not known yet. */
static tandem_status start(tandem_instance* self, double t, const double* x) {
  (void)t;
  *is_on(self) = x[0] > self->p[high];
  return TANDEM_OK;
}

static int is_beyond(const tandem_instance* self, const tandem_signal* x, double t) {
  const double value = tandem_signal_value(x, t);
  return *is_on(self) ? value < self->p[low] : value > self->p[high];
}

/* The first time of which is_beyond is known, by bisection; it is at `end`. */
static double find(const tandem_instance* self, const tandem_signal* x, double begin, double end) {
  double middle;
  while ((middle = begin + 0.5 * (end - begin)) > begin && middle < end)
    *(is_beyond(self, x, middle) ? &end : &begin) = middle;
  return end;
}

static tandem_status step(tandem_instance* self, tandem_own_step* own, const tandem_signal* x) {
  if (!is_beyond(self, x, own->end)) return TANDEM_OK;
  own->end = find(self, x, own->begin, own->end);
  own->event = 1;
  *is_on(self) = !*is_on(self);
  return TANDEM_OK;
}

static void give(const tandem_instance* self, double* y) { *y = self->p[*is_on(self) ? on : off]; }
static void give_before(const tandem_instance* self, double* y) { *y = self->p[*is_on(self) ? off : on]; }

static const tandem_model relay = {
    .info = {.name = "relay",
             .abilities = TANDEM_HOLDS | TANDEM_EVENTS,
             .input_count = 1,
             .output_count = 1,
             .inputs = inputs,
             .outputs = outputs},
    .parameters = parameters,
    .parameter_count = parameter_count,
    .state_size = sizeof(int),
    .own_step = own_step,
    .start = start,
    .step = step,
    .outputs = give,
    .outputs_before = give_before,
    .held = held,
};
TANDEM_EXPORT_FIXED_STEP(tandem_subsystem, relay)
