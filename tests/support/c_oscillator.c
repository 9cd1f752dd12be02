/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
#include "c_oscillator.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { max_saved = 8 };

typedef struct state {
  double x, v, force; /* the force at the end of the last step, for the output a */
  double t_start, time, next;
  int64_t index; /* of the node `next` */
} state;

typedef struct oscillator {
  double m, c, k, h, x0, v0;
  state now;
  state saved[max_saved];
  char used[max_saved];
  char error[160];
} oscillator;

static const tandem_port inputs[] = {{"F", "N", 1, 0, 0.0}};
static const tandem_port outputs[] = {
    {"x", "m", 1, 2, 0.0}, {"v", "m/s", 1, 1, 0.0}, {"a", "m/s^2", 1, 0, 0.0}};
static const tandem_feedthrough feedthrough[] = {{2, 0}};
static const tandem_info the_info = {
    "c_oscillator",
    TANDEM_LANDS | TANDEM_SAVES_STATE | TANDEM_RESTARTS | TANDEM_SERIALIZES_STATE,
    1,
    3,
    1,
    inputs,
    outputs,
    feedthrough};

static tandem_status fail(oscillator* o, tandem_status status, const char* sentence, const char* what) {
  snprintf(o->error, sizeof o->error, sentence, what);
  return status;
}

/* Width within which two times are the same, as subsystem.h says. */
static double width(const oscillator* o, double a, double b) {
  return 6.0 * DBL_EPSILON * fmax(fmax(fabs(a), fabs(b)), fabs(o->now.t_start));
}

static double acceleration(const oscillator* o, double x, double v, double force) {
  return (force - o->c * v - o->k * x) / o->m;
}

static void step(oscillator* o, double end, double h, const tandem_signal* u) {
  state* s = &o->now;
  const double begin = tandem_signal_value(u, s->time), middle = tandem_signal_value(u, s->time + 0.5 * h),
               at_end = tandem_signal_value(u, end);
  const double x1 = s->v, v1 = acceleration(o, s->x, s->v, begin);
  const double x2 = s->v + 0.5 * h * v1, v2 = acceleration(o, s->x + 0.5 * h * x1, x2, middle);
  const double x3 = s->v + 0.5 * h * v2, v3 = acceleration(o, s->x + 0.5 * h * x2, x3, middle);
  const double x4 = s->v + h * v3, v4 = acceleration(o, s->x + h * x3, x4, at_end);
  s->x += h / 6.0 * (x1 + 2.0 * x2 + 2.0 * x3 + x4);
  s->v += h / 6.0 * (v1 + 2.0 * v2 + 2.0 * v3 + v4);
  s->force = at_end;
  s->time = end;
}

/* Time, jump, then x, v, a, their first derivatives and their second ones. */
static void append(const oscillator* o, tandem_samples* y) {
  const state* s = &o->now;
  const double a = acceleration(o, s->x, s->v, s->force);
  const double row[] = {s->time, 0.0, s->x, s->v, a, s->v, a, 0.0, a, 0.0, 0.0};
  memcpy(y->rows + y->size++ * y->stride, row, sizeof row);
}

static void tell(const oscillator* o, tandem_stop stop, tandem_clock* clock) {
  clock->time = o->now.time;
  clock->next_time = o->now.next;
  clock->stop = stop;
  clock->reserved = 0;
}

static double* parameter(oscillator* o, char name, char second) {
  if (second == '=')
    return name == 'm' ? &o->m : name == 'c' ? &o->c : name == 'k' ? &o->k : name == 'h' ? &o->h : NULL;
  return second != '0' ? NULL : name == 'x' ? &o->x0 : name == 'v' ? &o->v0 : NULL;
}

static tandem_status create(const char* parameters, void** self) {
  oscillator* o = calloc(1, sizeof *o);
  const char* p = parameters;
  if (!(*self = o)) return TANDEM_INTERNAL;
  o->m = o->k = 1.0;
  o->h = 0.1;
  while (*p) {
    double* to = parameter(o, p[0], p[1]);
    const char* equals = strchr(p, '=');
    char* end = NULL;
    if (!to || !equals || equals - p > 2) return fail(o, TANDEM_INVALID_ARGUMENT, "no parameter '%s'", p);
    *to = strtod(equals + 1, &end);
    if (end == equals + 1 || (*end && *end != '&'))
      return fail(o, TANDEM_INVALID_ARGUMENT, "no number in '%s'", p);
    p = *end ? end + 1 : end;
  }
  if (!(o->m > 0.0) || !(o->h > 0.0))
    return fail(o, TANDEM_INVALID_ARGUMENT, "m and h have to be above 0%s", "");
  return TANDEM_OK;
}

static void destroy(void* self) { free(self); }
static const tandem_info* info(void* self) { return (void)self, &the_info; }
static const char* last_error(void* self) { return ((oscillator*)self)->error; }

static tandem_status initialize(void* self, double t_start, double t_stop, const double* u0,
                                tandem_samples* y, tandem_clock* clock) {
  oscillator* o = self;
  (void)t_stop;
  o->now.x = o->x0;
  o->now.v = o->v0;
  o->now.force = u0[0];
  o->now.t_start = o->now.time = t_start;
  o->now.index = 1;
  o->now.next = t_start + o->h;
  append(o, y);
  tell(o, TANDEM_STOP_LIMIT, clock);
  return TANDEM_OK;
}

static tandem_status advance(void* self, double t_limit, int32_t land, const tandem_signal* u,
                             tandem_samples* y, tandem_clock* clock) {
  oscillator* o = self;
  state* s = &o->now;
  for (; y->size < y->capacity; append(o, y)) {
    if (s->next <= t_limit + width(o, s->next, t_limit)) {
      const double node = s->t_start + (double)(s->index - 1) * o->h;
      step(o, s->next, s->time == node ? o->h : s->next - s->time, u);
      s->next = s->t_start + (double)(++s->index) * o->h; /* multiplied, never accumulated */
    } else if (land && s->time < t_limit - width(o, s->time, t_limit)) {
      step(o, t_limit, t_limit - s->time, u);
    } else {
      tell(o, TANDEM_STOP_LIMIT, clock);
      return TANDEM_OK;
    }
  }
  tell(o, TANDEM_STOP_SAMPLES_FULL, clock);
  return TANDEM_OK;
}

static tandem_status save_state(void* self, int64_t* id) {
  oscillator* o = self;
  int i;
  for (i = 0; i < max_saved; ++i)
    if (!o->used[i]) {
      o->used[i] = 1;
      o->saved[i] = o->now;
      *id = i;
      return TANDEM_OK;
    }
  return fail(o, TANDEM_INTERNAL, "no room for another saved state%s", "");
}

static int is_saved(const oscillator* o, int64_t id) { return id >= 0 && id < max_saved && o->used[id]; }

static tandem_status restore_state(void* self, int64_t id, tandem_clock* clock) {
  oscillator* o = self;
  if (!is_saved(o, id)) return fail(o, TANDEM_INVALID_ARGUMENT, "no such saved state%s", "");
  o->now = o->saved[id];
  tell(o, TANDEM_STOP_LIMIT, clock);
  return TANDEM_OK;
}

static tandem_status release_state(void* self, int64_t id) {
  oscillator* o = self;
  if (!is_saved(o, id)) return fail(o, TANDEM_INVALID_ARGUMENT, "no such saved state%s", "");
  o->used[id] = 0;
  return TANDEM_OK;
}

static tandem_status serialize_state(void* self, int64_t id, const void** bytes, int64_t* size) {
  oscillator* o = self;
  if (!is_saved(o, id)) return fail(o, TANDEM_INVALID_ARGUMENT, "no such saved state%s", "");
  *bytes = &o->saved[id];
  *size = sizeof(state);
  return TANDEM_OK;
}

static tandem_status deserialize_state(void* self, const void* bytes, int64_t size, int64_t* id) {
  oscillator* o = self;
  tandem_status saved;
  if (size != sizeof(state)) return fail(o, TANDEM_INVALID_ARGUMENT, "no state of an oscillator%s", "");
  saved = save_state(self, id);
  if (saved == TANDEM_OK) memcpy(&o->saved[*id], bytes, sizeof(state));
  return saved;
}

const tandem_subsystem_api* c_oscillator(void) {
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
