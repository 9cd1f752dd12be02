/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* TANDEM_EXPORT_FIXED_STEP(tandem_subsystem, model): a model (tandem/model.h) with a fixed own step. What is
 * done for it is what tandem/fixed_step.hpp does in C++: the grid of own steps, landing, early returns, saved states. Steps
 * are split where an input jumps. Events have both rows, and so have outputs that jump with an input. */
#ifndef TANDEM_FIXED_STEP_H
#define TANDEM_FIXED_STEP_H
#include <float.h>

#include "tandem/model_instance.h"

static inline tandem_status tandem_fixed_initialize(void* made, double t_start, double t_stop,
                                                    const double* u0, tandem_samples* y,
                                                    tandem_clock* clock) {
  tandem_instance* const self = (tandem_instance*)made;
  const double h = self->model->own_step(self);
  const tandem_place place = {t_start, h, t_start, t_start + h, 1, 0, 0};
  (void)t_stop;
  return tandem_begin(self, place, u0, y, clock);
}

/* By more than the tolerance that subsystem.h says. */
static inline int tandem_before(const tandem_instance* self, double a, double b) {
  return a < b && a < b - 6.0 * DBL_EPSILON * fmax(fmax(fabs(a), fabs(b)), fabs(self->now->origin));
}

static inline void tandem_find_jump(tandem_instance* self, double after) {
  size_t i;
  self->next_jump = INFINITY;
  for (i = 0; i < self->input_count; ++i)
    self->next_jump = fmin(self->next_jump, tandem_signal_next_jump(self->u + i, after));
}

static inline void tandem_pass_jump(tandem_instance* self) {
  size_t i;
  for (i = 0; i < self->input_count; ++i)
    self->signals[i] = tandem_signal_from_jump(self->u + i, self->next_jump);
  self->u = self->signals;
  tandem_find_jump(self, self->next_jump);
}

/* Inputs may also jump where a step of this call has ended: 0 if none does. */
static inline int tandem_pass_jumps(tandem_instance* self) {
  int any = 0;
  while (self->next_jump < self->now->next && !tandem_before(self, self->now->time, self->next_jump)) {
    tandem_pass_jump(self);
    any = 1;
  }
  return any;
}

/* Those of a call where it begins. */
static inline int tandem_have_jumped(const tandem_instance* self) {
  size_t i;
  for (i = 0; i < self->input_count; ++i)
    if (tandem_segment_jumps(self->u[i].segments) &&
        !tandem_before(self, self->u[i].segments->origin, self->now->time))
      return 1;
  return 0;
}

/* A second row where it stands and inputs have jumped; 0 if no output has with them. */
static inline int tandem_take_jump(tandem_instance* self, tandem_samples* y) {
  if (!self->model->jump || !self->model->jump(self, self->now->time, self->u)) return 0;
  tandem_append(self, self->model->outputs, 1.0, y);
  return 1;
}

/* The step in parts, from one jump of an input to the next, as far as an event. */
static inline tandem_status tandem_integrate(tandem_instance* self, tandem_own_step* s) {
  while (tandem_before(self, self->next_jump, s->end)) {
    tandem_own_step part = {s->begin, self->next_jump, self->next_jump - s->begin, 0};
    if (tandem_before(self, part.begin, part.end)) {
      const tandem_status status = self->model->step(self, &part, self->u);
      s->begin = part.end;
      s->length = s->end - s->begin;
      if (part.event) *s = part;
      if (status != TANDEM_OK || part.event) return status;
    }
    tandem_pass_jump(self);
  }
  return self->model->step(self, s, self->u);
}

static inline void tandem_move_to(tandem_instance* self, double t) {
  tandem_place* const now = self->now;
  now->cut = tandem_before(self, t, now->next);
  now->time = now->cut ? t : now->next;
  if (!now->cut) now->next = now->origin + (double)++now->node * now->h; /* multiplied, never accumulated */
}

/* A row as it was before the event, unless it stands there already, and one as it is now. */
static inline tandem_status tandem_stop_at(tandem_instance* self, double t, tandem_samples* y,
                                           tandem_clock* clock) {
  if (tandem_before(self, self->now->time, t)) {
    tandem_move_to(self, t);
    tandem_append(self, self->model->outputs_before, 0.0, y);
  }
  tandem_append(self, self->model->outputs, 1.0, y);
  return tandem_tell(self, TANDEM_STOP_EVENT, clock);
}

/* Of the inputs of a call. */
static inline tandem_status tandem_take_reaction(tandem_instance* self) {
  size_t i;
  self->reaction = NULL;
  for (i = 0; i < self->input_count && !self->reaction; ++i)
    if (self->u[i].reactive) self->reaction = self->u[i].reactive->reaction;
  if (!self->reaction) return TANDEM_OK;
  if (self->reaction->states < 0 || (size_t)self->reaction->states > 6 * self->input_count)
    return tandem_refuse(self, TANDEM_NOT_SUPPORTED, "its inputs react by %d states; allowed are up to %d",
                         (int)self->reaction->states, (int)(6 * self->input_count));
  memcpy(self->z, self->reaction->begin, (size_t)self->reaction->states * sizeof(double));
  return TANDEM_OK;
}

static inline tandem_status tandem_fixed_advance(void* made, double t_limit, int32_t land,
                                                 const tandem_signal* u, tandem_samples* y,
                                                 tandem_clock* clock) {
  tandem_instance* const self = (tandem_instance*)made;
  const tandem_place* const now = self->now;
  const int64_t rows = self->info.abilities & TANDEM_EVENTS ? 2 : 1; /* that a step may give */
  self->u = u;
  if (tandem_take_reaction(self) != TANDEM_OK) return TANDEM_NOT_SUPPORTED;
  tandem_find_jump(self, now->time);
  if (y->size < y->capacity && tandem_have_jumped(self)) tandem_take_jump(self, y);
  while (y->size + rows <= y->capacity) {
    const int whole = !tandem_before(self, t_limit, now->next);
    const double end = whole ? now->next : t_limit;
    tandem_own_step s = {now->time, end, whole && !now->cut ? now->h : end - now->time, 0};
    tandem_status status;
    if (!whole && !(land && tandem_before(self, now->time, t_limit)))
      return tandem_tell(self, TANDEM_STOP_LIMIT, clock);
    if (tandem_pass_jumps(self) && tandem_take_jump(self, y)) continue;
    if ((status = tandem_integrate(self, &s)) != TANDEM_OK) return status;
    if (s.event) return tandem_stop_at(self, s.end, y, clock);
    tandem_move_to(self, s.end);
    tandem_append(self, self->model->outputs, 0.0, y);
  }
  return tandem_tell(self, TANDEM_STOP_SAMPLES_FULL, clock);
}

#define TANDEM_EXPORT_FIXED_STEP(entry, model) \
  TANDEM_MODEL_TABLE(entry, model, TANDEM_LANDS, tandem_fixed_initialize, tandem_fixed_advance, NULL, NULL)

#endif
