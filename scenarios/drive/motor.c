/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* A direct-current motor with its current loop, as a shared library: tandem/subsystem.h is all that it needs.
 *   L i' = kp (i_ref - i) + ki z - R i - k w,   z' = i_ref - i,   torque = k i
 * by the classical Runge-Kutta method, from one jump of an input to the next. Inputs: i_ref [A], w, the speed
 * of its shaft [rad/s]; outputs: torque [N m], i [A]. Parameters, each of them needed: R [ohm], L [H], k [N
 * m/A], kp [V/A], ki [V/(A s)], and the own step h [s]. It starts without current. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tandem/subsystem.h"

enum { R, L, k, kp, ki, h, parameter_count };
static const char* const names[parameter_count] = {"R", "L", "k", "kp", "ki", "h"};
enum { i_ref, w, input_count };
enum { current, integral, state_count };
enum { most_saved = 8 };

typedef struct state {
  double x[state_count];
  double t_start, time, next;
  int64_t node; /* number of the node `next` */
} state;

typedef struct motor {
  double p[parameter_count];
  state now, saved[most_saved];
  char used[most_saved];
  char error[200];
} motor;

static const tandem_port inputs[] = {{"i_ref", "A", 1, 0, NAN}, {"w", "rad/s", 1, 0, NAN}};
static const tandem_port outputs[] = {{"torque", "N m", 1, 0, NAN}, {"i", "A", 1, 0, NAN}};
static const tandem_info the_info = {
    "motor", TANDEM_LANDS | TANDEM_RESTARTS | TANDEM_SAVES_STATE | TANDEM_SERIALIZES_STATE,
    2,       2,
    0,       inputs,
    outputs, NULL};

static tandem_status refuse(motor* m, const char* sentence, const char* what) {
  snprintf(m->error, sizeof m->error, sentence, what);
  return TANDEM_INVALID_ARGUMENT;
}

static int index_of(const char* pair) {
  const size_t length = strcspn(pair, "=");
  int i;
  for (i = 0; i < parameter_count; ++i)
    if (strlen(names[i]) == length && strncmp(pair, names[i], length) == 0) return i;
  return -1;
}

static tandem_status read_parameters(motor* m, const char* pair) {
  int i;
  for (i = 0; i < parameter_count; ++i) m->p[i] = NAN;
  while (*pair) {
    char* end;
    const char* number;
    if ((i = index_of(pair)) < 0) return refuse(m, "'%s' is no parameter of R, L, k, kp, ki, h", pair);
    number = pair + strlen(names[i]) + 1;
    m->p[i] = strtod(number, &end);
    if (end == number || (*end && *end != '&')) return refuse(m, "no number in '%s'", pair);
    pair = *end ? end + 1 : end;
  }
  for (i = 0; i < parameter_count; ++i)
    if (!isfinite(m->p[i])) return refuse(m, "the parameter '%s' is needed, a finite number", names[i]);
  if (!(m->p[L] > 0.0 && m->p[h] > 0.0)) return refuse(m, "L and h have to be above 0%s", "");
  return TANDEM_OK;
}

static tandem_status create(const char* parameters, void** self) {
  *self = calloc(1, sizeof(motor));
  return *self ? read_parameters(*self, parameters) : TANDEM_INTERNAL;
}
static void destroy(void* self) { free(self); }
static const tandem_info* info(void* self) { return (void)self, &the_info; }
static const char* last_error(void* self) { return ((motor*)self)->error; }

/* Width within which two times are the same, as subsystem.h says. */
static double width(const motor* m, double a, double b) {
  return 6.0 * DBL_EPSILON * fmax(fmax(fabs(a), fabs(b)), fabs(m->now.t_start));
}

static void append(const motor* m, tandem_samples* y) {
  const state* s = &m->now;
  const double row[] = {s->time, 0.0, m->p[k] * s->x[current], s->x[current]};
  memcpy(y->rows + y->size++ * y->stride, row, sizeof row);
}

/* x' at t, where the state is x + step slope. */
static void rates(const motor* m, double t, const tandem_signal* u, double step, const double* slope,
                  double* dx) {
  const double* p = m->p;
  const double i = m->now.x[current] + step * slope[current], z = m->now.x[integral] + step * slope[integral];
  const double late = tandem_signal_value(&u[i_ref], t) - i;
  dx[current] = (p[kp] * late + p[ki] * z - p[R] * i - p[k] * tandem_signal_value(&u[w], t)) / p[L];
  dx[integral] = late;
}

/* Over a time in which no input jumps. */
static void integrate(motor* m, double begin, double end, const tandem_signal* u) {
  const double length = end - begin, middle = begin + 0.5 * length, none[state_count] = {0.0, 0.0};
  double a[state_count], b[state_count], c[state_count], d[state_count];
  int n;
  rates(m, begin, u, 0.0, none, a);
  rates(m, middle, u, 0.5 * length, a, b);
  rates(m, middle, u, 0.5 * length, b, c);
  rates(m, end, u, length, c, d);
  for (n = 0; n < state_count; ++n) m->now.x[n] += length / 6.0 * (a[n] + 2.0 * b[n] + 2.0 * c[n] + d[n]);
}

/* The first jump of the signal after t; infinite if there is none. */
static double next_jump(const tandem_signal* u, double t) {
  int32_t n;
  for (n = 0; n < u->count; ++n)
    if (tandem_segment_jumps(u->segments + n) && u->segments[n].origin > t) return u->segments[n].origin;
  return INFINITY;
}

/* The signal from its jump at t on, whose value there is the one after it; all of it if it has none there. */
static tandem_signal from_jump(const tandem_signal* u, double t) {
  tandem_signal rest = *u;
  int32_t n;
  for (n = 0; n < u->count; ++n)
    if (tandem_segment_jumps(u->segments + n) && u->segments[n].origin == t) {
      rest.segments = u->segments + n;
      rest.count = u->count - n;
      break;
    }
  return rest;
}

/* The first jump of an input within begin and end; `end` if there is none. */
static double end_of_part(const motor* m, const tandem_signal* u, double begin, double end) {
  const double jump = fmin(next_jump(&u[i_ref], begin), next_jump(&u[w], begin));
  return jump < end - width(m, jump, end) ? jump : end;
}

/* An own step, in parts from one jump to the next. The inputs u are left as they hold at its end. */
static void step(motor* m, double end, tandem_signal* u) {
  double begin = m->now.time, part;
  int n;
  for (; (part = end_of_part(m, u, begin, end)) < end; begin = part) {
    if (part > begin + width(m, begin, part)) integrate(m, begin, part, u);
    for (n = 0; n < input_count; ++n) u[n] = from_jump(&u[n], part);
  }
  integrate(m, begin, end, u);
  m->now.time = end;
}

static void tell(const motor* m, tandem_stop stop, tandem_clock* clock) {
  clock->time = m->now.time;
  clock->next_time = m->now.next;
  clock->stop = stop;
  clock->reserved = 0;
}

static tandem_status initialize(void* self, double t_start, double t_stop, const double* u0,
                                tandem_samples* y, tandem_clock* clock) {
  motor* m = self;
  state* s = &m->now;
  (void)t_stop, (void)u0;
  memset(s, 0, sizeof *s);
  s->t_start = s->time = t_start;
  s->node = 1;
  s->next = t_start + m->p[h];
  append(m, y);
  tell(m, TANDEM_STOP_LIMIT, clock);
  return TANDEM_OK;
}

static tandem_status advance(void* self, double t_limit, int32_t land, const tandem_signal* given,
                             tandem_samples* y, tandem_clock* clock) {
  motor* m = self;
  state* s = &m->now;
  tandem_signal u[input_count];
  memcpy(u, given, sizeof u);
  for (; y->size < y->capacity; append(m, y)) {
    if (s->next <= t_limit + width(m, s->next, t_limit)) {
      step(m, s->next, u);
      s->next = s->t_start + (double)++s->node * m->p[h]; /* multiplied, never accumulated */
    } else if (land && s->time < t_limit - width(m, s->time, t_limit)) {
      step(m, t_limit, u);
    } else {
      tell(m, TANDEM_STOP_LIMIT, clock);
      return TANDEM_OK;
    }
  }
  tell(m, TANDEM_STOP_SAMPLES_FULL, clock);
  return TANDEM_OK;
}

static tandem_status keep(motor* m, const state* what, int64_t* id) {
  for (*id = 0; *id < most_saved; ++*id)
    if (!m->used[*id]) {
      m->used[*id] = 1;
      m->saved[*id] = *what;
      return TANDEM_OK;
    }
  return refuse(m, "there is no room for another saved state%s", "");
}

static int is_saved(const motor* m, int64_t id) { return id >= 0 && id < most_saved && m->used[id]; }

static tandem_status save_state(void* self, int64_t* id) { return keep(self, &((motor*)self)->now, id); }

static tandem_status restore_state(void* self, int64_t id, tandem_clock* clock) {
  motor* m = self;
  if (!is_saved(m, id)) return refuse(m, "there is no such saved state%s", "");
  m->now = m->saved[id];
  tell(m, TANDEM_STOP_LIMIT, clock);
  return TANDEM_OK;
}

static tandem_status release_state(void* self, int64_t id) {
  motor* m = self;
  if (!is_saved(m, id)) return refuse(m, "there is no such saved state%s", "");
  m->used[id] = 0;
  return TANDEM_OK;
}

/* As it stands in memory: for machines of one kind. */
static tandem_status serialize_state(void* self, int64_t id, const void** bytes, int64_t* size) {
  motor* m = self;
  if (!is_saved(m, id)) return refuse(m, "there is no such saved state%s", "");
  *bytes = &m->saved[id];
  *size = sizeof(state);
  return TANDEM_OK;
}

static tandem_status deserialize_state(void* self, const void* bytes, int64_t size, int64_t* id) {
  motor* m = self;
  state its;
  if (size != sizeof(state)) return refuse(m, "the state has not as many bytes as the motor has%s", "");
  memcpy(&its, bytes, sizeof its);
  if (its.t_start != m->now.t_start || its.next != its.t_start + (double)its.node * m->p[h])
    return refuse(m, "the state is of other own steps%s", "");
  return keep(m, &its, id);
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
