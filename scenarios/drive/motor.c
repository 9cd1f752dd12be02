/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* A direct-current motor with its current loop, as a shared library.
 *   L i' = kp (i_ref - i) + ki z - R i - k w,   z' = i_ref - i,   torque = k i
 * by the classical Runge-Kutta method. Inputs: i_ref [A], w, the speed of its shaft [rad/s]; outputs: torque
 * [N m], i [A]. It starts without current. */
#include "tandem/fixed_step.h"

enum { R, L, k, kp, ki, h, parameter_count };
static const tandem_parameter parameters[parameter_count] = {
    {"R", "ohm", NULL, "resistance"},
    {"L", "H", NULL, "inductance"},
    {"k", "N m/A", NULL, "torque of a current"},
    {"kp", "V/A", NULL, "proportional gain of the current loop"},
    {"ki", "V/(A s)", NULL, "integral gain of the current loop"},
    {"h", "s", NULL, "own step"},
};

enum { i_ref, w };
enum { current, integral, state_count };
static const tandem_port inputs[] = {{"i_ref", "A", 1, 0, NAN}, {"w", "rad/s", 1, 0, NAN}};
static const tandem_port outputs[] = {{"torque", "N m", 1, 0, NAN}, {"i", "A", 1, 0, NAN}};

static tandem_status check(tandem_instance* self) {
  if (self->p[L] > 0.0) return TANDEM_OK;
  return tandem_refuse(self, TANDEM_INVALID_ARGUMENT, "L is %g H; allowed is one above 0", self->p[L]);
}

static double own_step(const tandem_instance* self) { return self->p[h]; }

static tandem_status start(tandem_instance* self, double t, const double* u0) {
  (void)t, (void)u0;
  memset(self->state, 0, state_count * sizeof(double));
  return TANDEM_OK;
}

/* x' at t, where the state is x + step slope. */
static void rates(const tandem_instance* self, double t, const tandem_signal* u, double step,
                  const double* slope, double* dx) {
  const double *p = self->p, *x = self->state;
  const double i = x[current] + step * slope[current], z = x[integral] + step * slope[integral];
  const double late = tandem_signal_value(&u[i_ref], t) - i;
  dx[current] = (p[kp] * late + p[ki] * z - p[R] * i - p[k] * tandem_signal_value(&u[w], t)) / p[L];
  dx[integral] = late;
}

static tandem_status step(tandem_instance* self, tandem_own_step* own, const tandem_signal* u) {
  const double length = own->end - own->begin, middle = own->begin + 0.5 * length,
               none[state_count] = {0.0, 0.0};
  double a[state_count], b[state_count], c[state_count], d[state_count], *x = self->state;
  int n;
  rates(self, own->begin, u, 0.0, none, a);
  rates(self, middle, u, 0.5 * length, a, b);
  rates(self, middle, u, 0.5 * length, b, c);
  rates(self, own->end, u, length, c, d);
  for (n = 0; n < state_count; ++n) x[n] += length / 6.0 * (a[n] + 2.0 * b[n] + 2.0 * c[n] + d[n]);
  return TANDEM_OK;
}

static void give(const tandem_instance* self, double* y) {
  const double* x = self->state;
  y[0] = self->p[k] * x[current];
  y[1] = x[current];
}

static const tandem_model motor = {
    .info = {.name = "motor", .input_count = 2, .output_count = 2, .inputs = inputs, .outputs = outputs},
    .parameters = parameters,
    .parameter_count = parameter_count,
    .state_size = state_count * sizeof(double),
    .own_step = own_step,
    .start = start,
    .step = step,
    .outputs = give,
    .check = check,
};
TANDEM_EXPORT_FIXED_STEP(tandem_subsystem, motor)
