/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* Mass 2 of the two-mass test in C99, as a shared library: tandem/subsystem.h is all that it needs.
 *   m x'' = k u - s x,  by the trapezoidal rule, solved exactly; u is read anew at both ends of a step.
 * Input x1 [m]; outputs x2 [m] with two time derivatives, v2 [m/s] with one. Parameters: m [kg], k, s [N/m],
 * x, v (at the start) and h [s], each of them needed. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tandem/subsystem.h"

enum { m, k, stiffness, x, v, h, parameter_count };
static const char* const names[parameter_count] = {"m", "k", "s", "x", "v", "h"};

enum { most_saved = 8 };

typedef struct state {
  double x, v, a;
  double t_start, time, next;
  int64_t node; /* number of the node `next` */
  int64_t cut;  /* the last step ended before its node */
} state;

typedef struct mass2 {
  double p[parameter_count];
  state now, saved[most_saved];
  char used[most_saved];
  char error[200];
} mass2;

static const tandem_port inputs[] = {{"x1", "m", 1, 0, NAN}};
static const tandem_port outputs[] = {{"x2", "m", 1, 2, NAN}, {"v2", "m/s", 1, 1, NAN}};
static const tandem_info the_info = {
    "mass2", TANDEM_LANDS | TANDEM_RESTARTS | TANDEM_SAVES_STATE | TANDEM_SERIALIZES_STATE,
    1,       2,
    0,       inputs,
    outputs, NULL};

static tandem_status refuse(mass2* s, const char* sentence, const char* what) {
  snprintf(s->error, sizeof s->error, sentence, what);
  return TANDEM_INVALID_ARGUMENT;
}

static int index_of(const char* pair) {
  int i;
  for (i = 0; i < parameter_count; ++i)
    if (pair[0] == names[i][0] && pair[1] == '=') return i;
  return -1;
}

static tandem_status read_parameters(mass2* s, const char* pair) {
  int i;
  for (i = 0; i < parameter_count; ++i) s->p[i] = NAN;
  while (*pair) {
    char* end;
    if ((i = index_of(pair)) < 0) return refuse(s, "'%s' begins with no parameter of m, k, s, x, v, h", pair);
    s->p[i] = strtod(pair + 2, &end);
    if (end == pair + 2 || (*end && *end != '&')) return refuse(s, "no number in '%s'", pair);
    pair = *end ? end + 1 : end;
  }
  for (i = 0; i < parameter_count; ++i)
    if (!isfinite(s->p[i])) return refuse(s, "the parameter '%s' is needed, a finite number", names[i]);
  if (!(s->p[m] > 0.0 && s->p[h] > 0.0)) return refuse(s, "m and h have to be above 0%s", "");
  return TANDEM_OK;
}

static tandem_status create(const char* parameters, void** self) {
  *self = calloc(1, sizeof(mass2));
  return *self ? read_parameters(*self, parameters) : TANDEM_INTERNAL;
}
static void destroy(void* self) { free(self); }
static const tandem_info* info(void* self) { return (void)self, &the_info; }
static const char* last_error(void* self) { return ((mass2*)self)->error; }

/* Width within which two times are the same, as subsystem.h says. */
static double width(const mass2* s, double a, double b) {
  return 6.0 * DBL_EPSILON * fmax(fmax(fabs(a), fabs(b)), fabs(s->now.t_start));
}

static void append(const mass2* m2, tandem_samples* y) {
  const state* s = &m2->now;
  const double row[] = {s->time, 0.0, s->x, s->v, s->v, s->a, s->a, 0.0};
  memcpy(y->rows + y->size++ * y->stride, row, sizeof row);
}

static void step(mass2* m2, double end, const tandem_signal* u) {
  const double* p = m2->p;
  state* s = &m2->now;
  const double length = end == s->next && !s->cut ? p[h] : end - s->time;
  const double before = (p[k] * tandem_signal_value(u, s->time) - p[stiffness] * s->x) / p[m];
  const double push = p[k] * tandem_signal_value(u, end);
  s->x = (s->x + length * s->v + 0.25 * length * length * (before + push / p[m])) /
         (1.0 + 0.25 * length * length * p[stiffness] / p[m]);
  s->a = (push - p[stiffness] * s->x) / p[m];
  s->v += 0.5 * length * (before + s->a);
  s->time = end;
}

static void tell(const mass2* s, tandem_stop stop, tandem_clock* clock) {
  clock->time = s->now.time;
  clock->next_time = s->now.next;
  clock->stop = stop;
  clock->reserved = 0;
}

static tandem_status initialize(void* self, double t_start, double t_stop, const double* u0,
                                tandem_samples* y, tandem_clock* clock) {
  mass2* m2 = self;
  state* s = &m2->now;
  (void)t_stop;
  s->x = m2->p[x];
  s->v = m2->p[v];
  s->a = (m2->p[k] * u0[0] - m2->p[stiffness] * s->x) / m2->p[m];
  s->t_start = s->time = t_start;
  s->node = 1;
  s->next = t_start + m2->p[h];
  s->cut = 0;
  append(m2, y);
  tell(m2, TANDEM_STOP_LIMIT, clock);
  return TANDEM_OK;
}

static tandem_status advance(void* self, double t_limit, int32_t land, const tandem_signal* u,
                             tandem_samples* y, tandem_clock* clock) {
  mass2* m2 = self;
  state* s = &m2->now;
  for (; y->size < y->capacity; append(m2, y)) {
    if (s->next <= t_limit + width(m2, s->next, t_limit)) {
      step(m2, s->next, u);
      s->next = s->t_start + (double)++s->node * m2->p[h]; /* multiplied, never accumulated */
      s->cut = 0;
    } else if (land && s->time < t_limit - width(m2, s->time, t_limit)) {
      step(m2, t_limit, u);
      s->cut = 1;
    } else {
      tell(m2, TANDEM_STOP_LIMIT, clock);
      return TANDEM_OK;
    }
  }
  tell(m2, TANDEM_STOP_SAMPLES_FULL, clock);
  return TANDEM_OK;
}

static tandem_status keep(mass2* s, const state* what, int64_t* id) {
  for (*id = 0; *id < most_saved; ++*id)
    if (!s->used[*id]) {
      s->used[*id] = 1;
      s->saved[*id] = *what;
      return TANDEM_OK;
    }
  return refuse(s, "there is no room for another saved state%s", "");
}

static int is_saved(const mass2* s, int64_t id) { return id >= 0 && id < most_saved && s->used[id]; }

static tandem_status save_state(void* self, int64_t* id) { return keep(self, &((mass2*)self)->now, id); }

static tandem_status restore_state(void* self, int64_t id, tandem_clock* clock) {
  mass2* s = self;
  if (!is_saved(s, id)) return refuse(s, "there is no such saved state%s", "");
  s->now = s->saved[id];
  tell(s, TANDEM_STOP_LIMIT, clock);
  return TANDEM_OK;
}

static tandem_status release_state(void* self, int64_t id) {
  mass2* s = self;
  if (!is_saved(s, id)) return refuse(s, "there is no such saved state%s", "");
  s->used[id] = 0;
  return TANDEM_OK;
}

/* As it stands in memory: for machines of one kind. */
static tandem_status serialize_state(void* self, int64_t id, const void** bytes, int64_t* size) {
  mass2* s = self;
  if (!is_saved(s, id)) return refuse(s, "there is no such saved state%s", "");
  *bytes = &s->saved[id];
  *size = sizeof(state);
  return TANDEM_OK;
}

static tandem_status deserialize_state(void* self, const void* bytes, int64_t size, int64_t* id) {
  mass2* s = self;
  state its;
  if (size != sizeof(state)) return refuse(s, "the state has not as many bytes as mass2 has%s", "");
  memcpy(&its, bytes, sizeof its);
  if (its.t_start != s->now.t_start || its.next != its.t_start + (double)its.node * s->p[h])
    return refuse(s, "the state is of other own steps%s", "");
  return keep(s, &its, id);
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
      .save_state = save_state,
      .restore_state = restore_state,
      .release_state = release_state,
      .serialize_state = serialize_state,
      .deserialize_state = deserialize_state,
  };
  return &api;
}
