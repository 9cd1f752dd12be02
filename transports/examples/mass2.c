/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* Mass 2 of the two-mass test in C99, as a shared library.
 *   m x'' = k u - s x,  by the trapezoidal rule, solved exactly; u is read anew at both ends of a step.
 * Input x1 [m]; outputs x2 [m] with two time derivatives, v2 [m/s] with one. */
#include "tandem/fixed_step.h"

enum { m, k, stiffness, x, v, h, parameter_count };
static const tandem_parameter parameters[parameter_count] = {
    {"m", "kg", NULL, "mass"},
    {"k", "N/m", NULL, "stiffness of the spring to mass 1"},
    {"s", "N/m", NULL, "stiffness of both springs together"},
    {"x", "m", NULL, "position at the start"},
    {"v", "m/s", NULL, "speed at the start"},
    {"h", "s", NULL, "own step"},
};

static const tandem_port inputs[] = {{"x1", "m", 1, 0, NAN}};
static const tandem_port outputs[] = {{"x2", "m", 1, 2, NAN}, {"v2", "m/s", 1, 1, NAN}};

typedef struct state {
  double x, v, a;
} state;

static tandem_status check(tandem_instance* self) {
  if (self->p[m] > 0.0) return TANDEM_OK;
  return tandem_refuse(self, TANDEM_INVALID_ARGUMENT, "m is %g kg; allowed is a mass above 0", self->p[m]);
}

static double own_step(const tandem_instance* self) { return self->p[h]; }

static tandem_status start(tandem_instance* self, double t, const double* u0) {
  const double* p = self->p;
  state* s = self->state;
  (void)t;
  s->x = p[x];
  s->v = p[v];
  s->a = (p[k] * u0[0] - p[stiffness] * s->x) / p[m];
  return TANDEM_OK;
}

static tandem_status step(tandem_instance* self, tandem_own_step* own, const tandem_signal* u) {
  const double *p = self->p, length = own->length;
  state* s = self->state;
  const double before = (p[k] * tandem_signal_value(u, own->begin) - p[stiffness] * s->x) / p[m];
  const double push = p[k] * tandem_signal_value(u, own->end);
  s->x = (s->x + length * s->v + 0.25 * length * length * (before + push / p[m])) /
         (1.0 + 0.25 * length * length * p[stiffness] / p[m]);
  s->a = (push - p[stiffness] * s->x) / p[m];
  s->v += 0.5 * length * (before + s->a);
  return TANDEM_OK;
}

static void give(const tandem_instance* self, double* y) {
  const state* s = self->state;
  const double row[] = {s->x, s->v, s->v, s->a, s->a, 0.0};
  memcpy(y, row, sizeof row);
}

static const tandem_model mass2 = {
    .info = {.name = "mass2", .input_count = 1, .output_count = 2, .inputs = inputs, .outputs = outputs},
    .parameters = parameters,
    .parameter_count = parameter_count,
    .state_size = sizeof(state),
    .own_step = own_step,
    .start = start,
    .step = step,
    .outputs = give,
    .check = check,
};
TANDEM_EXPORT_FIXED_STEP(tandem_subsystem, mass2)
