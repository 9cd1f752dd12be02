/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* Mass 1 of the two-mass test in C99, as a shared library whose input may react (tandem/reaction.h).
 *   m x'' = -s x - F,  F = k (x - u),  by the classical Runge-Kutta method.
 * Input x2 [m]; outputs x1 [m] with one time derivative, v1 [m/s], F [N], which follows x2 at once. */
#include "tandem/fixed_step.h"

enum { m, k, ground, x, v, h, parameter_count };
static const tandem_parameter parameters[parameter_count] = {
    {"m", "kg", NULL, "mass"},
    {"k", "N/m", NULL, "stiffness of the spring to mass 2"},
    {"s", "N/m", NULL, "stiffness of the spring to the wall"},
    {"x", "m", NULL, "position at the start"},
    {"v", "m/s", NULL, "speed at the start"},
    {"h", "s", NULL, "own step"},
};

static const tandem_port inputs[] = {{"x2", "m", 1, 0, NAN}};
static const tandem_port outputs[] = {{"x1", "m", 1, 1, NAN}, {"v1", "m/s", 1, 0, NAN}, {"F", "N", 1, 0, NAN}};
static const tandem_feedthrough feedthrough[] = {{2, 0}};

enum { most = 2 + 6 }; /* states: its own, then those of a reaction by its one input */

typedef struct state {
  double x, v, force;
} state;

static double own_step(const tandem_instance* self) { return self->p[h]; }

static tandem_status start(tandem_instance* self, double t, const double* u0) {
  state* s = self->state;
  (void)t;
  s->x = self->p[x];
  s->v = self->p[v];
  s->force = self->p[k] * (s->x - u0[0]);
  return TANDEM_OK;
}

static double force(const tandem_instance* self, const tandem_signal* u, double t, const double* w) {
  return self->p[k] * (w[0] - tandem_reactive_value(u, t, w + 2));
}

static void rates(const tandem_instance* self, const tandem_signal* u, double t, const double* w, double* dw) {
  const double y[] = {w[0], w[1], force(self, u, t, w)};
  dw[0] = w[1];
  dw[1] = (-self->p[ground] * w[0] - y[2]) / self->p[m];
  if (self->reaction) tandem_reaction_rates(self->reaction, t, w + 2, y, dw + 2);
}

static tandem_status step(tandem_instance* self, tandem_own_step* own, const tandem_signal* u) {
  state* s = self->state;
  const int n = 2 + (self->reaction ? self->reaction->states : 0);
  const double length = own->length, at[] = {0.0, 0.5 * length, 0.5 * length, length}, weight[] = {1, 2, 2, 1};
  double begin[most] = {0}, w[most] = {0}, dw[most] = {0}, sum[most] = {0};
  int stage, i;
  begin[0] = s->x;
  begin[1] = s->v;
  for (i = 2; i < n; ++i) begin[i] = self->z[i - 2];
  for (stage = 0; stage < 4; ++stage) {
    for (i = 0; i < n; ++i) w[i] = begin[i] + at[stage] * dw[i];
    rates(self, u, own->begin + at[stage], w, dw);
    for (i = 0; i < n; ++i) sum[i] += weight[stage] * dw[i];
  }
  for (i = 0; i < n; ++i) w[i] = begin[i] + length / 6.0 * sum[i];
  s->x = w[0];
  s->v = w[1];
  for (i = 2; i < n; ++i) self->z[i - 2] = w[i];
  s->force = force(self, u, own->end, w);
  return TANDEM_OK;
}

static void give(const tandem_instance* self, double* y) {
  const state* s = self->state;
  const double row[] = {s->x, s->v, s->force, s->v, 0.0, 0.0};
  memcpy(y, row, sizeof row);
}

static const tandem_model mass1 = {
    .info = {.name = "mass1",
             .abilities = TANDEM_REACTIVE_INPUTS,
             .input_count = 1,
             .output_count = 3,
             .feedthrough_count = 1,
             .inputs = inputs,
             .outputs = outputs,
             .feedthrough = feedthrough},
    .parameters = parameters,
    .parameter_count = parameter_count,
    .state_size = sizeof(state),
    .own_step = own_step,
    .start = start,
    .step = step,
    .outputs = give,
};
TANDEM_EXPORT_FIXED_STEP(tandem_subsystem, mass1)
