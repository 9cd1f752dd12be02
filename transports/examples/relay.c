/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* A relay in C99, as a shared library: a subsystem with events. Its output F [N] is held: `off` at the start;
 * `on` from where its input x [m] rises above `high`, `off` from where it falls below `low`. Parameters, each
 * of them needed: high, low [m], on, off [N], and the own step h [s], at whose ends x is looked at. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tandem/subsystem.h"

enum { high, low, on, off, h, parameter_count };
static const char* const names[parameter_count] = {"high", "low", "on", "off", "h"};

typedef struct relay {
  double p[parameter_count], t_start, time, next;
  int64_t node; /* number of the node `next` */
  int is_on;
  char error[100];
} relay;

static const tandem_port inputs[] = {{"x", "m", 1, 0, NAN}};
static const tandem_port outputs[] = {{"F", "N", 1, 0, NAN}};
static const int32_t held_outputs[] = {1};
static const tandem_info the_info = {
    "relay", TANDEM_LANDS | TANDEM_RESTARTS | TANDEM_HOLDS | TANDEM_EVENTS, 1, 1, 0, inputs, outputs, NULL};

static tandem_status create(const char* parameters, void** self) {
  relay* r = *self = calloc(1, sizeof(relay));
  int i;
  if (!r) return TANDEM_INTERNAL;
  for (i = 0; i < parameter_count; ++i) {
    char key[8];
    const char* at = parameters;
    const int length = snprintf(key, sizeof key, "%s=", names[i]);
    while (at && strncmp(at, key, (size_t)length) != 0) at = strchr(at, '&') ? strchr(at, '&') + 1 : NULL;
    if (!at || sscanf(at + length, "%lf", &r->p[i]) != 1 || !isfinite(r->p[i])) {
      snprintf(r->error, sizeof r->error, "the parameter '%s' is needed, a finite number", names[i]);
      return TANDEM_INVALID_ARGUMENT;
    }
  }
  return TANDEM_OK;
}
static void destroy(void* self) { free(self); }
static const tandem_info* info(void* self) { return (void)self, &the_info; }
static const char* last_error(void* self) { return ((relay*)self)->error; }
static const int32_t* held(void* self) { return (void)self, held_outputs; }

/* Width within which two times are the same, as subsystem.h says. */
static double width(const relay* r, double a, double b) {
  return 6.0 * DBL_EPSILON * fmax(fmax(fabs(a), fabs(b)), fabs(r->t_start));
}

static void append(const relay* r, double jump, tandem_samples* y) {
  const double row[] = {r->time, jump, r->p[r->is_on ? on : off]};
  memcpy(y->rows + y->size++ * y->stride, row, sizeof row);
}

static tandem_status tell(const relay* r, tandem_stop stop, tandem_clock* clock) {
  const tandem_clock now = {r->time, r->next, stop, 0};
  *clock = now;
  return TANDEM_OK;
}

static tandem_status initialize(void* self, double t_start, double t_stop, const double* u0,
                                tandem_samples* y, tandem_clock* clock) {
  relay* r = self;
  (void)t_stop;
  r->t_start = r->time = t_start;
  r->next = t_start + r->p[h];
  r->node = 1;
  r->is_on = u0[0] > r->p[high]; /* off where x is not known yet */
  append(r, 0.0, y);
  return tell(r, TANDEM_STOP_LIMIT, clock);
}

static int is_beyond(const relay* r, const tandem_signal* x, double t) {
  const double value = tandem_signal_value(x, t);
  return r->is_on ? value < r->p[low] : value > r->p[high];
}

/* The first time of which is_beyond is known, by bisection; it is at `end`. */
static double find(const relay* r, const tandem_signal* x, double end) {
  double begin = r->time, middle;
  while ((middle = begin + 0.5 * (end - begin)) > begin && middle < end)
    *(is_beyond(r, x, middle) ? &end : &begin) = middle;
  return end;
}

/* Two rows at one time: the output before, unless it was given there already, and, marked, after the event.
 */
static tandem_status switch_over(relay* r, double t, tandem_samples* y, tandem_clock* clock) {
  if (t > r->time + width(r, t, t)) r->time = t, append(r, 0.0, y);
  r->is_on = !r->is_on;
  append(r, 1.0, y);
  return tell(r, TANDEM_STOP_EVENT, clock);
}

/* Room for the two rows of an event is kept. */
static tandem_status advance(void* self, double t_limit, int32_t land, const tandem_signal* u,
                             tandem_samples* y, tandem_clock* clock) {
  relay* r = self;
  while (y->size + 1 < y->capacity) {
    const int whole = r->next <= t_limit + width(r, r->next, t_limit);
    const double end = whole ? r->next : t_limit;
    double event;
    if (!whole && !(land && r->time < t_limit - width(r, r->time, t_limit)))
      return tell(r, TANDEM_STOP_LIMIT, clock);
    event = is_beyond(r, u, end) ? find(r, u, end) : INFINITY;
    if (event < end - width(r, end, end)) return switch_over(r, event, y, clock);
    r->time = end;
    if (whole) r->next = r->t_start + (double)++r->node * r->p[h]; /* multiplied, never accumulated */
    append(r, 0.0, y);
    if (event <= end) return switch_over(r, end, y, clock);
  }
  return tell(r, TANDEM_STOP_SAMPLES_FULL, clock);
}

const tandem_subsystem_api* tandem_subsystem(void) {
  static const tandem_subsystem_api api = {
      .abi_version = TANDEM_ABI_VERSION,
      .table_size = sizeof(tandem_subsystem_api),
      .create = create,
      .destroy = destroy,
      .info = info,
      .last_error = last_error,
      .initialize = initialize,
      .advance = advance,
      .held = held,
  };
  return &api;
}
