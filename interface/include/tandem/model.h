/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* A model in C99 or C++ that is its equations: a few functions, and the parameters that it takes. One line
 * makes of it a subsystem, and exports the function that gives its table (subsystem.h):
 *   TANDEM_EXPORT_FIXED_STEP(tandem_subsystem, model)   with a fixed own step: include fixed_step.h
 *   TANDEM_EXPORT_SAMPLED(tandem_subsystem, model)      that samples: include sampled.h */
#ifndef TANDEM_MODEL_H
#define TANDEM_MODEL_H
#include <stdarg.h>
#include <stdio.h>

#include "tandem/reaction.h"
#include "tandem/subsystem.h"

/* Where an instance stands. Its state follows. */
typedef struct tandem_place {
  double origin, h, time, next; /* of the grid, its step, where it stands, the next node: origin + node * h */
  int64_t node;
  int32_t cut, kept; /* the last step ended before its node; of a saved one: it is not released */
} tandem_place;

/* What the model's functions are given, for its first five members. */
typedef struct tandem_instance {
  const double* p;          /* the values of the parameters, in their order; NAN of a word */
  const char* const* words; /* their texts */
  void* state;              /* of as many bytes as the model says */
  /* With TANDEM_REACTIVE_INPUTS, NULL where no input of the call reacts; and its states, which are right where `step`
   * begins, and which it takes along. */
  const tandem_reaction* reaction;
  double* z;
  const struct tandem_model* model;
  tandem_info info;
  struct tandem_values* values;
  tandem_place* now;
  void* saved; /* places with their states, of place_size bytes each */
  int64_t saved_count;
  size_t place_size, input_count;
  const tandem_signal* u;    /* the inputs of a call, from their last jump on */
  tandem_signal* signals;    /* room for them */
  tandem_segment* constants; /* and for those of a sample */
  double next_jump;
  char error[256];
} tandem_instance;

/* From begin to end [s]; length is h, or less where a step is cut. A model with TANDEM_EVENTS whose outputs
 * jump comes as far as that, and sets `end` to its time and `event`, which is 0, to 1. */
typedef struct tandem_own_step {
  double begin, end, length;
  int32_t event;
} tandem_own_step;

typedef struct tandem_model {
  tandem_info info; /* its abilities besides saving, landing, restarting and sampling */
  const tandem_parameter* parameters;
  int32_t parameter_count;
  size_t state_size; /* of plain data without pointers: a copy of it is a saved state */
  double (*own_step)(const tandem_instance*);                           /* h, or the period of samples [s] */
  tandem_status (*start)(tandem_instance*, double t, const double* u0); /* u0 may hold NAN */
  tandem_status (*step)(tandem_instance*, tandem_own_step*, const tandem_signal* u);
  void (*outputs)(const tandem_instance*, double* y); /* then derivatives, as the state is */
  /* NULL if there is no need of them: */
  tandem_status (*check)(tandem_instance*);                               /* of the parameters, once */
  void (*outputs_before)(const tandem_instance*, double* y);              /* just before an event */
  void (*outputs_at)(const tandem_instance*, double* y, const double* u); /* of a sample, with its inputs */
  double (*offset)(const tandem_instance*);                               /* of the first sample [s] */
  double (*latency)(const tandem_instance*);                              /* of the outputs of a sample [s] */
  const int32_t* held;                                                    /* by output */
  const double* nominal;                                                  /* likewise */
  /* With feedthrough: inputs have jumped at t, where it stands; not 0: outputs have with them. */
  int32_t (*jump)(tandem_instance*, double t, const tandem_signal* u);
} tandem_model;

/* An error with its sentence: return tandem_refuse(self, TANDEM_NUMERICAL, "no solution at t = %g s", t). */
static inline tandem_status tandem_refuse(tandem_instance* self, tandem_status status, const char* form,
                                          ...) {
  va_list values;
  va_start(values, form);
  vsnprintf(self->error, sizeof self->error, form, values);
  va_end(values);
  return status;
}

#endif
