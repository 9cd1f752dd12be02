/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* What fixed_step.h and sampled.h have in common: instances of a model, and the table of functions. */
#ifndef TANDEM_MODEL_INSTANCE_H
#define TANDEM_MODEL_INSTANCE_H
#include "tandem/parameters.h"
#include "tandem/saved_states.h"

static inline tandem_status tandem_make(const tandem_model* model, const char* parameters, uint32_t abilities,
                                        void** made) {
  tandem_instance* const self = (tandem_instance*)calloc(1, sizeof *self);
  int32_t i;
  if (!(*made = self)) return TANDEM_INTERNAL;
  self->model = model;
  self->info = model->info;
  self->info.abilities |= abilities | TANDEM_RESTARTS | TANDEM_SAVES_STATE | TANDEM_SERIALIZES_STATE;
  for (i = 0; i < model->info.input_count; ++i) self->input_count += (size_t)model->info.inputs[i].size;
  self->place_size = sizeof(tandem_place) + (model->state_size + 15) / 16 * 16;
  self->now = (tandem_place*)calloc(1, self->place_size);
  self->signals = (tandem_signal*)calloc(self->input_count + 1, sizeof(tandem_signal));
  self->constants = (tandem_segment*)calloc(self->input_count + 1, sizeof(tandem_segment));
  self->z = (double*)calloc(6 * self->input_count + 1, sizeof(double));
  self->values = tandem_read_parameters(model->parameters, model->parameter_count, parameters);
  if (!self->now || !self->signals || !self->constants || !self->z || !self->values)
    return tandem_refuse(self, TANDEM_INTERNAL, "there is no memory for an instance");
  if (self->values->error[0]) return tandem_refuse(self, TANDEM_INVALID_ARGUMENT, "%s", self->values->error);
  self->p = self->values->p;
  self->words = self->values->words;
  self->state = self->now + 1;
  return model->check ? model->check(self) : TANDEM_OK;
}

static inline void tandem_destroy(void* made) {
  tandem_instance* const self = (tandem_instance*)made;
  free(self->values);
  free(self->constants);
  free(self->z);
  free(self->signals);
  free(self->now);
  free(self->saved);
  free(self);
}

static inline const tandem_info* tandem_info_of(void* made) { return &((tandem_instance*)made)->info; }
static inline const char* tandem_error_of(void* made) { return ((tandem_instance*)made)->error; }
static inline const int32_t* tandem_held(void* made) { return ((tandem_instance*)made)->model->held; }
static inline const double* tandem_nominal(void* made) { return ((tandem_instance*)made)->model->nominal; }

/* A row with what `outputs` gives; it ends with the states of a reaction. */
static inline void tandem_append(const tandem_instance* self,
                                 void (*outputs)(const tandem_instance*, double*), double jump,
                                 tandem_samples* y) {
  double* const row = y->rows + y->size++ * y->stride;
  row[0] = self->now->time;
  row[1] = jump;
  outputs(self, row + 2);
  if (self->reaction)
    memcpy(row + y->stride - self->reaction->states, self->z,
           (size_t)self->reaction->states * sizeof(double));
}

/* Puts it there, with the first row. */
static inline tandem_status tandem_begin(tandem_instance* self, tandem_place place, const double* u0,
                                         tandem_samples* y, tandem_clock* clock) {
  tandem_status status;
  if (!(place.h > 0.0 && isfinite(place.h) && place.origin + place.h > place.origin))
    return tandem_refuse(self, TANDEM_INVALID_ARGUMENT, "the own step is %g s; allowed is one above 0",
                         place.h);
  *self->now = place;
  self->reaction = NULL;
  if ((status = self->model->start(self, place.time, u0)) != TANDEM_OK) return status;
  tandem_append(self, self->model->outputs, 0.0, y);
  return tandem_tell(self, TANDEM_STOP_LIMIT, clock);
}

#ifdef __cplusplus
#define TANDEM_ENTRY extern "C"
#else
#define TANDEM_ENTRY extern
#endif

/* The function that gives the table of a model. */
#define TANDEM_MODEL_TABLE(entry, model, abilities, initialize, advance, sampling, sample)               \
  static tandem_status entry##_create(const char* entry##_text, void** entry##_made) {                   \
    return tandem_make(&(model), entry##_text, abilities, entry##_made);                                 \
  }                                                                                                      \
  static const tandem_parameter* entry##_parameters(int32_t* entry##_count) {                            \
    *entry##_count = (model).parameter_count;                                                            \
    return (model).parameters;                                                                           \
  }                                                                                                      \
  TANDEM_ENTRY const tandem_subsystem_api* entry(void);                                                  \
  TANDEM_ENTRY const tandem_subsystem_api* entry(void) {                                                 \
    static const tandem_subsystem_api entry##_table = {TANDEM_ABI_VERSION, sizeof(tandem_subsystem_api), \
                                                       entry##_create,     tandem_destroy,               \
                                                       tandem_info_of,     tandem_error_of,              \
                                                       initialize,         advance,                      \
                                                       tandem_save,        tandem_restore,               \
                                                       tandem_release,     tandem_serialize,             \
                                                       tandem_deserialize, tandem_held,                  \
                                                       sampling,           sample,                       \
                                                       entry##_parameters, tandem_nominal};              \
    return &entry##_table;                                                                               \
  }

#endif
