/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* A PI controller that samples, in C99, as a shared library: tandem/subsystem.h is all that it needs.
 *   at t_start + offset + k T:   u = kp e + s,   then   s becomes s + ki T e,   e = r - y
 * Input y [m]; output u [N], which holds. Parameters, each of them needed: kp [N/m], ki [N/(m s)], r [m], T
 * [s], the offset of the first instant [s], and the latency [s], by which u changes later than the instant.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tandem/subsystem.h"

enum { kp, ki, r, T, offset, latency, parameter_count };
static const char* const names[parameter_count] = {"kp", "ki", "r", "T", "offset", "latency"};

typedef struct pi {
  double p[parameter_count];
  double s;           /* the integral part */
  double first, time; /* instant, and where it stands [s] */
  int64_t instant;    /* number of the next one */
  char error[200];
} pi;

static const tandem_port inputs[] = {{"y", "m", 1, 0, NAN}};
static const tandem_port outputs[] = {{"u", "N", 1, 0, NAN}};
static const tandem_feedthrough feedthrough[] = {{0, 0}};
static const tandem_info the_info = {"pi",       TANDEM_SAMPLED | TANDEM_RESTARTS, 1, 1, 1, inputs, outputs,
                                     feedthrough};

static tandem_status refuse(pi* c, const char* sentence, const char* what) {
  snprintf(c->error, sizeof c->error, sentence, what);
  return TANDEM_INVALID_ARGUMENT;
}

static int index_of(const char* pair) {
  const size_t length = strcspn(pair, "=");
  int i;
  for (i = 0; i < parameter_count; ++i)
    if (strlen(names[i]) == length && strncmp(pair, names[i], length) == 0) return i;
  return -1;
}

static tandem_status read_parameters(pi* c, const char* pair) {
  int i;
  for (i = 0; i < parameter_count; ++i) c->p[i] = NAN;
  while (*pair) {
    char* end;
    const char* number;
    if ((i = index_of(pair)) < 0) return refuse(c, "'%s' is no parameter", pair);
    number = pair + strlen(names[i]) + 1;
    c->p[i] = strtod(number, &end);
    if (end == number || (*end && *end != '&')) return refuse(c, "no number in '%s'", pair);
    pair = *end ? end + 1 : end;
  }
  for (i = 0; i < parameter_count; ++i)
    if (!isfinite(c->p[i])) return refuse(c, "the parameter '%s' is needed, a finite number", names[i]);
  return TANDEM_OK;
}

static tandem_status create(const char* parameters, void** self) {
  *self = calloc(1, sizeof(pi));
  return *self ? read_parameters(*self, parameters) : TANDEM_INTERNAL;
}
static void destroy(void* self) { free(self); }
static const tandem_info* info(void* self) { return (void)self, &the_info; }
static const char* last_error(void* self) { return ((pi*)self)->error; }

static tandem_status sampling(void* self, double* period, double* late) {
  *period = ((pi*)self)->p[T];
  *late = ((pi*)self)->p[latency];
  return TANDEM_OK;
}

static void tell(const pi* c, tandem_clock* clock) {
  clock->time = c->time;
  clock->next_time = c->first + (double)c->instant * c->p[T]; /* multiplied, never accumulated */
  clock->stop = TANDEM_STOP_LIMIT;
  clock->reserved = 0;
}

/* Before the first instant the integral part alone holds. */
static tandem_status initialize(void* self, double t_start, double t_stop, const double* u0,
                                tandem_samples* y, tandem_clock* clock) {
  pi* const c = self;
  double* const row = y->rows + y->size++ * y->stride;
  (void)t_stop, (void)u0;
  c->s = 0.0;
  c->first = t_start + c->p[offset];
  c->time = t_start;
  c->instant = 0;
  row[0] = t_start;
  row[1] = 0.0;
  row[2] = c->s;
  tell(c, clock);
  return TANDEM_OK;
}

static tandem_status sample(void* self, double t, int32_t parts, const double* y, double* u,
                            tandem_clock* clock) {
  pi* const c = self;
  const double e = c->p[r] - y[0];
  if (parts & TANDEM_SAMPLE_OUTPUTS) u[0] = c->p[kp] * e + c->s;
  if (parts & TANDEM_SAMPLE_STATES) {
    c->s += c->p[ki] * c->p[T] * e;
    c->time = t;
    ++c->instant;
  }
  tell(c, clock);
  return TANDEM_OK;
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
      .sampling = sampling,
      .sample = sample,
  };
  return &api;
}
