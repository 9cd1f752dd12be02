/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
#include "c_models.h"

#include "tandem/fixed_step.h"
#include "tandem/sampled.h"

/* ---- c_integral ---- */

enum { gain, fails_at, rule, integral_step, integral_parameters };
static const tandem_parameter parameters_of_integral[] = {{"gain", "1", "2", "factor of u"},
                                                          {"fails_at", "s", "1e300", "where a step fails"},
                                                          {"rule", NULL, "simpson", "simpson or euler"},
                                                          {"h", "s", "0.1", "own step"}};
static const tandem_port inputs_of_integral[] = {{"u", "m/s", 1, 0, 0.0}};
static const tandem_port outputs_of_integral[] = {{"x", "m", 1, 0, NAN}, {"steps", "1", 1, 0, NAN}};
static const double nominal_of_integral[] = {3.0, 1.0};

typedef struct integral {
  double x, steps;
} integral;

static double own_step(const tandem_instance* self) { return self->p[integral_step]; }

static tandem_status check_integral(tandem_instance* self) {
  const char* const word = self->words[rule];
  if (strcmp(word, "simpson") == 0 || strcmp(word, "euler") == 0) return TANDEM_OK;
  return tandem_refuse(self, TANDEM_INVALID_ARGUMENT, "rule is '%s'; allowed are simpson and euler", word);
}

static tandem_status start_integral(tandem_instance* self, double t, const double* u0) {
  integral* s = self->state;
  (void)t, (void)u0;
  s->x = s->steps = 0.0;
  return TANDEM_OK;
}

static tandem_status step_integral(tandem_instance* self, tandem_own_step* own, const tandem_signal* u) {
  integral* s = self->state;
  const double first = tandem_signal_value(u, own->begin),
               middle = tandem_signal_value(u, own->begin + own->length / 2.0),
               last = tandem_signal_value(u, own->end);
  const double mean = self->words[rule][0] == 'e' ? first : (first + 4.0 * middle + last) / 6.0;
  if (own->end > self->p[fails_at])
    return tandem_refuse(self, TANDEM_NUMERICAL, "no step to t = %g s", own->end);
  s->x += self->p[gain] * own->length * mean;
  s->steps += 1.0;
  return TANDEM_OK;
}

static void give_integral(const tandem_instance* self, double* y) {
  const integral* s = self->state;
  y[0] = s->x;
  y[1] = s->steps;
}

static const tandem_model integral_model = {
    .info = {.name = "integral",
             .input_count = 1,
             .output_count = 2,
             .inputs = inputs_of_integral,
             .outputs = outputs_of_integral},
    .parameters = parameters_of_integral,
    .parameter_count = integral_parameters,
    .state_size = sizeof(integral),
    .own_step = own_step,
    .start = start_integral,
    .step = step_integral,
    .outputs = give_integral,
    .check = check_integral,
    .nominal = nominal_of_integral,
};
TANDEM_EXPORT_FIXED_STEP(c_integral, integral_model)

/* ---- c_switch ---- */

enum { switch_width, step_of_switch, switch_parameters };
static const tandem_parameter parameters_of_switch[] = {{"width", "m", "0.1", "half its hysteresis"},
                                                        {"h", "s", "0.07", "own step"}};
static const tandem_port inputs_of_switch[] = {{"x", "m", 1, 0, 0.0}};
static const tandem_port outputs_of_switch[] = {{"r", "m/s", 1, 0, NAN}, {"c", "m", 1, 0, NAN}};
static const int32_t held_of_switch[] = {1, 0};

typedef struct switch_state {
  double r, before, c;
} switch_state;

static double own_step_of_switch(const tandem_instance* self) { return self->p[step_of_switch]; }

static tandem_status start_switch(tandem_instance* self, double t, const double* x) {
  switch_state* s = self->state;
  (void)t, (void)x;
  s->r = s->before = 1.0;
  s->c = 0.0;
  return TANDEM_OK;
}

static int is_beyond(const tandem_instance* self, const tandem_signal* x, double t) {
  const switch_state* s = self->state;
  const double value = tandem_signal_value(x, t);
  return s->r > 0.0 ? value > self->p[switch_width] : value < -self->p[switch_width];
}

static tandem_status step_switch(tandem_instance* self, tandem_own_step* own, const tandem_signal* x) {
  switch_state* s = self->state;
  double low = own->begin, high = own->end, middle;
  own->event = is_beyond(self, x, high);
  while (own->event && (middle = low + (high - low) / 2.0) > low && middle < high)
    *(is_beyond(self, x, middle) ? &high : &low) = middle;
  own->end = high;
  s->c += s->r * (own->end - own->begin);
  s->before = s->r;
  if (own->event) s->r = -s->r;
  return TANDEM_OK;
}

static void give_switch(const tandem_instance* self, double* y) {
  const switch_state* s = self->state;
  y[0] = s->r;
  y[1] = s->c + s->r;
}

static void give_switch_before(const tandem_instance* self, double* y) {
  const switch_state* s = self->state;
  y[0] = s->before;
  y[1] = s->c + s->before;
}

static const tandem_model switch_model = {
    .info = {.name = "switch",
             .abilities = TANDEM_HOLDS | TANDEM_EVENTS,
             .input_count = 1,
             .output_count = 2,
             .inputs = inputs_of_switch,
             .outputs = outputs_of_switch},
    .parameters = parameters_of_switch,
    .parameter_count = switch_parameters,
    .state_size = sizeof(switch_state),
    .own_step = own_step_of_switch,
    .start = start_switch,
    .step = step_switch,
    .outputs = give_switch,
    .outputs_before = give_switch_before,
    .held = held_of_switch,
};
TANDEM_EXPORT_FIXED_STEP(c_switch, switch_model)

/* ---- c_sum ---- */

enum { period, first, late, at_once, sum_parameters };
static const tandem_parameter parameters_of_sum[] = {{"T", "s", "0.25", "period"},
                                                     {"offset", "s", "0.1", "of the first instant"},
                                                     {"latency", "s", "0.02", "of the output"},
                                                     {"gain", "1", "0.5", "of the input in the output"}};
static const tandem_feedthrough feedthrough_of_sum[] = {{0, 0}};

static double period_of_sum(const tandem_instance* self) { return self->p[period]; }
static double offset_of_sum(const tandem_instance* self) { return self->p[first]; }
static double latency_of_sum(const tandem_instance* self) { return self->p[late]; }

static tandem_status start_sum(tandem_instance* self, double t, const double* u0) {
  (void)t, (void)u0;
  *(double*)self->state = 0.0;
  return TANDEM_OK;
}

static tandem_status step_sum(tandem_instance* self, tandem_own_step* own, const tandem_signal* u) {
  *(double*)self->state += tandem_signal_value(u, own->begin);
  return TANDEM_OK;
}

static void give_sum(const tandem_instance* self, double* y) { *y = *(const double*)self->state; }
static void give_sum_at(const tandem_instance* self, double* y, const double* u) {
  *y = *(const double*)self->state + self->p[at_once] * u[0];
}

static const tandem_model sum_model = {
    .info = {.name = "sum",
             .input_count = 1,
             .output_count = 1,
             .feedthrough_count = 1,
             .inputs = inputs_of_switch,
             .outputs = inputs_of_switch,
             .feedthrough = feedthrough_of_sum},
    .parameters = parameters_of_sum,
    .parameter_count = sum_parameters,
    .state_size = sizeof(double),
    .own_step = period_of_sum,
    .start = start_sum,
    .step = step_sum,
    .outputs = give_sum,
    .outputs_at = give_sum_at,
    .offset = offset_of_sum,
    .latency = latency_of_sum,
};
TANDEM_EXPORT_SAMPLED(c_sum, sum_model)

/* ---- c_follower ---- */

static const tandem_port inputs_of_follower[] = {{"u", "m", 1, 0, NAN}};
static const tandem_port outputs_of_follower[] = {{"y", "m", 1, 0, NAN}};
static const tandem_feedthrough feedthrough_of_follower[] = {{0, 0}};

typedef struct follower {
  double x, u;
} follower;

static double step_of_follower(const tandem_instance* self) {
  (void)self;
  return 0.07;
}

static tandem_status start_follower(tandem_instance* self, double t, const double* u0) {
  follower* s = self->state;
  (void)t;
  s->x = 0.0, s->u = u0[0];
  return TANDEM_OK;
}

static tandem_status step_follower(tandem_instance* self, tandem_own_step* own, const tandem_signal* u) {
  follower* s = self->state;
  s->x += own->length * tandem_signal_value(u, own->begin + own->length / 2.0);
  s->u = tandem_signal_value(u, own->end);
  return TANDEM_OK;
}

static int32_t jump_follower(tandem_instance* self, double t, const tandem_signal* u) {
  follower* s = self->state;
  const double before = s->u;
  s->u = tandem_signal_value(u, t);
  return s->u != before;
}

static void give_follower(const tandem_instance* self, double* y) {
  const follower* s = self->state;
  y[0] = s->x + s->u;
}

static const tandem_model follower_model = {.info = {.name = "follower",
                                                     .input_count = 1,
                                                     .output_count = 1,
                                                     .feedthrough_count = 1,
                                                     .inputs = inputs_of_follower,
                                                     .outputs = outputs_of_follower,
                                                     .feedthrough = feedthrough_of_follower},
                                            .state_size = sizeof(follower),
                                            .own_step = step_of_follower,
                                            .start = start_follower,
                                            .step = step_follower,
                                            .outputs = give_follower,
                                            .jump = jump_follower};
TANDEM_EXPORT_FIXED_STEP(c_follower, follower_model)
