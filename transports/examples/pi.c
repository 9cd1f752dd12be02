/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* A PI controller that samples, in C99, as a shared library.
 *   at t_start + offset + k T:   u = kp e + s,   then   s becomes s + ki T e,   e = r - y
 * Input y [m]; output u [N], which holds. */
#include "tandem/sampled.h"

enum { kp, ki, r, T, offset, latency, parameter_count };
static const tandem_parameter parameters[parameter_count] = {
    {"kp", "N/m", NULL, "proportional gain"},
    {"ki", "N/(m s)", NULL, "integral gain"},
    {"r", "m", NULL, "what y is to be"},
    {"T", "s", NULL, "period"},
    {"offset", "s", NULL, "of the first instant"},
    {"latency", "s", NULL, "by which u changes later than the instant"},
};

static const tandem_port inputs[] = {{"y", "m", 1, 0, NAN}};
static const tandem_port outputs[] = {{"u", "N", 1, 0, NAN}};
static const tandem_feedthrough feedthrough[] = {{0, 0}};

/* The state is the integral part. */
static double* integral(const tandem_instance* self) { return self->state; }

static double period(const tandem_instance* self) { return self->p[T]; }
static double first(const tandem_instance* self) { return self->p[offset]; }
static double late(const tandem_instance* self) { return self->p[latency]; }

static tandem_status start(tandem_instance* self, double t, const double* y0) {
  (void)t, (void)y0;
  *integral(self) = 0.0;
  return TANDEM_OK;
}

static tandem_status step(tandem_instance* self, tandem_own_step* own, const tandem_signal* y) {
  const double* p = self->p;
  *integral(self) += p[ki] * p[T] * (p[r] - tandem_signal_value(y, own->begin));
  return TANDEM_OK;
}

/* Before the first instant the integral part alone holds. */
static void give_before(const tandem_instance* self, double* u) { *u = *integral(self); }

static void give(const tandem_instance* self, double* u, const double* y) {
  *u = self->p[kp] * (self->p[r] - *y) + *integral(self);
}

static const tandem_model pi = {
    .info = {.name = "pi",
             .input_count = 1,
             .output_count = 1,
             .feedthrough_count = 1,
             .inputs = inputs,
             .outputs = outputs,
             .feedthrough = feedthrough},
    .parameters = parameters,
    .parameter_count = parameter_count,
    .state_size = sizeof(double),
    .own_step = period,
    .start = start,
    .step = step,
    .outputs = give_before,
    .outputs_at = give,
    .offset = first,
    .latency = late,
};
TANDEM_EXPORT_SAMPLED(tandem_subsystem, pi)
