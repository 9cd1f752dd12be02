/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* TANDEM_EXPORT_SAMPLED(tandem_subsystem, model): a model (tandem/model.h) that samples, with the period
 * own_step(). At each instant t_start + offset + k h it gives its outputs: as its state is or, where inputs
 * feed through, by outputs_at. Then it steps from there to the next instant on its inputs as they were at
 * this one. Before the first instant the outputs of the model as it was started hold. */
#ifndef TANDEM_SAMPLED_H
#define TANDEM_SAMPLED_H
#include "tandem/model_instance.h"

static inline tandem_status tandem_sampled_initialize(void* made, double t_start, double t_stop,
                                                      const double* u0, tandem_samples* y,
                                                      tandem_clock* clock) {
  tandem_instance* const self = (tandem_instance*)made;
  const tandem_model* const model = self->model;
  const double first = t_start + (model->offset ? model->offset(self) : 0.0);
  const tandem_place place = {first, model->own_step(self), t_start, first, 0, 0, 0};
  (void)t_stop;
  return tandem_begin(self, place, u0, y, clock);
}

static inline tandem_status tandem_sampling(void* made, double* period, double* latency) {
  const tandem_instance* const self = (const tandem_instance*)made;
  *period = self->model->own_step(self);
  *latency = self->model->latency ? self->model->latency(self) : 0.0;
  return TANDEM_OK;
}

/* From the instant t to the next one, on inputs that hold. */
static inline tandem_status tandem_go_on(tandem_instance* self, double t, const double* u) {
  tandem_place* const now = self->now;
  const double next = now->origin + (double)(now->node + 1) * now->h; /* multiplied, never accumulated */
  tandem_own_step s = {t, next, now->h, 0};
  tandem_status status;
  size_t i;
  for (i = 0; i < self->input_count; ++i) {
    self->constants[i].end = self->constants[i].origin = t;
    self->constants[i].c[0] = u[i];
    self->signals[i].segments = self->constants + i;
    self->signals[i].count = 1;
  }
  if ((status = self->model->step(self, &s, self->signals)) != TANDEM_OK) return status;
  now->time = t;
  now->next = next;
  ++now->node;
  return TANDEM_OK;
}

static inline tandem_status tandem_sample(void* made, double t, int32_t parts, const double* u, double* y,
                                          tandem_clock* clock) {
  tandem_instance* const self = (tandem_instance*)made;
  tandem_status status = TANDEM_OK;
  if (parts & TANDEM_SAMPLE_OUTPUTS && self->model->outputs_at)
    self->model->outputs_at(self, y, u);
  else if (parts & TANDEM_SAMPLE_OUTPUTS)
    self->model->outputs(self, y);
  if (parts & TANDEM_SAMPLE_STATES) status = tandem_go_on(self, t, u);
  return status == TANDEM_OK ? tandem_tell(self, TANDEM_STOP_LIMIT, clock) : status;
}

#define TANDEM_EXPORT_SAMPLED(entry, model)                                                          \
  TANDEM_MODEL_TABLE(entry, model, TANDEM_SAMPLED, tandem_sampled_initialize, NULL, tandem_sampling, \
                     tandem_sample)

#endif
