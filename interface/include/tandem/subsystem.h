/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* The subsystem contract in C99. A subsystem integrates itself with its own step; the coordinator tells it up
 * to where, and gives every input as a function of time. Data in, data out: nothing calls back, so the same
 * contract holds in one process, in a shared library and over a socket.
 *
 * Units are SI (time in s) unless a port says otherwise. Numbers are IEEE doubles. Inputs are functions of
 * time: tandem/signal.h.
 *
 * Order of calls:  create  info  initialize+  advance* (or sample*)  destroy
 * `initialize` may be called again before the first `advance`; afterwards only with TANDEM_RESTARTS.
 * Calls on one instance never overlap; different instances may be called from different threads.
 *
 * Ownership: what `info` points to belongs to the subsystem and lives until `destroy`. Signals and samples
 * belong to the caller and are valid during the call only. Errors: a function returns a tandem_status;
 * `last_error` then gives a sentence, valid until the next call on that instance. No function may throw or
 * longjmp through its caller. */
#ifndef TANDEM_SUBSYSTEM_H
#define TANDEM_SUBSYSTEM_H
#include <stddef.h>
#include <stdint.h>

#include "tandem/signal.h"
#include "tandem/subsystem_info.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TANDEM_ABI_VERSION 1

typedef enum tandem_status {
  TANDEM_OK = 0,
  TANDEM_INVALID_ARGUMENT = 1, /* a value the caller gave: port, unit, step, parameter */
  TANDEM_NOT_SUPPORTED = 2,    /* asked for something the subsystem or scheme has not */
  TANDEM_WRONG_STATE = 3,      /* a call out of order */
  TANDEM_NUMERICAL = 4,        /* the integration failed: not finite, no convergence */
  TANDEM_INPUT_OUTPUT = 5,     /* a file or a stream */
  TANDEM_INTERNAL = 6          /* anything else */
} tandem_status;

/* Rows in the caller's memory. A row is `stride` doubles: time, jump (1: nothing before this row may be
 * fitted together with it; else 0), the outputs, then their first time derivatives, their second ones, as
 * many blocks as tandem_info says (0 where a port has fewer). Append at rows + size * stride and count up
 * `size`; never rewrite a row; return early with TANDEM_STOP_SAMPLES_FULL when size == capacity. */
typedef struct tandem_samples {
  double* rows;
  int64_t stride, capacity, size;
} tandem_samples;

typedef enum tandem_stop {
  TANDEM_STOP_LIMIT = 0,        /* the next own step would end beyond t_limit */
  TANDEM_STOP_EVENT = 1,        /* stopped early at an event; go on by calling again */
  TANDEM_STOP_SAMPLES_FULL = 2, /* no room for another row; go on by calling again */
  TANDEM_STOP_FINISHED = 3      /* will not go on, whatever the limit */
} tandem_stop;

enum { /* what a sampled subsystem is to do at an instant */
  TANDEM_SAMPLE_OUTPUTS = 1, /* give its outputs; nothing else changes, and it may be asked again */
  TANDEM_SAMPLE_STATES = 2   /* go on to the next instant; after the outputs where both are asked for */
};

/* Where the subsystem stands, where its next own step would end (> time), and why it returned. */
typedef struct tandem_clock {
  double time;
  double next_time;
  int32_t stop;
  int32_t reserved;
} tandem_clock;

/* The table of functions; new functions are added at its end only, and a table_size that ends before one says
 * that it is not there. `self` is what create gave. */
typedef struct tandem_subsystem_api {
  uint32_t abi_version; /* TANDEM_ABI_VERSION */
  uint32_t table_size;  /* sizeof(tandem_subsystem_api) of the one who built it */

  /* A new instance. `parameters` is "key=value" pairs joined by '&', or "". On failure *self may still be an
   * instance that last_error can be asked about; it is destroyed in any case if not NULL. */
  tandem_status (*create)(const char* parameters, void** self);
  void (*destroy)(void* self);
  const tandem_info* (*info)(void* self);
  const char* (*last_error)(void* self);

  /* Puts the state at t_start and appends the first sample. t_stop: the end of the run, past which it is not
   * asked to go. u0: one value per scalar input, NaN where it is not known yet; outputs without feedthrough
   * from an unknown input must come back finite all the same. */
  tandem_status (*initialize)(void* self, double t_start, double t_stop, const double* u0, tandem_samples* y,
                              tandem_clock* clock);

  /* Takes own steps for as long as they end at or before t_limit (compare with a tolerance of 6 DBL_EPSILON
   * max(|t|, |t_start|); a strict comparison costs extra calls), and appends one row for each. u: one signal
   * per scalar input, covering [time, t_limit]. land != 0: the last step is cut so that it ends at t_limit;
   * the grid of own steps stays as it was. Time after the call is that of the last row. */
  tandem_status (*advance)(void* self, double t_limit, int32_t land, const tandem_signal* u,
                           tandem_samples* y, tandem_clock* clock);

  /* With TANDEM_SAVES_STATE only, else NULL. A saved state stays valid until released or destroyed. */
  tandem_status (*save_state)(void* self, int64_t* id);
  tandem_status (*restore_state)(void* self, int64_t id, tandem_clock* clock);
  tandem_status (*release_state)(void* self, int64_t id);

  /* With TANDEM_SERIALIZES_STATE (beside TANDEM_SAVES_STATE) only, else NULL. A saved state as bytes, which
   * belong to the subsystem and are valid until the next call on that instance; and from bytes a saved state.
   * They are for an instance that is made with the same parameters and initialized with the same span and
   * inputs, in this process or another; restored there, it goes on with the same bits as this one does. With
   * this ability save_state leaves what follows as it would be without it. Bytes of another subsystem, or not
   * whole, are TANDEM_INVALID_ARGUMENT, where that can be told. */
  tandem_status (*serialize_state)(void* self, int64_t id, const void** bytes, int64_t* size);
  tandem_status (*deserialize_state)(void* self, const void* bytes, int64_t size, int64_t* id);

  /* With TANDEM_HOLDS only, else NULL: a flag by output, 1 if it is held: constant from each of its samples,
   * that instant included, to the next. It belongs to the subsystem and lives until `destroy`. */
  const int32_t* (*held)(void* self);

  /* With TANDEM_SAMPLED only, else NULL; `advance` may then be NULL, as it is not called. `initialize` gives
   * the outputs that hold before the first instant, which is next_time, t_start or later.
   * sampling: period [s], the least time between two instants, above 0; latency [s]: the outputs change this
   * long after each instant, 0 or more. Both are constant.
   * sample: acts at the instant t [s], its next_time. parts: TANDEM_SAMPLE_... or both. u: one value per scalar
   * input at t, of other sampled subsystems with what is new at t; for the states it is as for the outputs, but
   * for inputs that do not feed through. y: one value per scalar output, to be given with the outputs; they
   * hold from t + latency until the next ones do. clock: where it stands (t) and its next instant. */
  tandem_status (*sampling)(void* self, double* period, double* latency);
  tandem_status (*sample)(void* self, double t, int32_t parts, const double* u, double* y, tandem_clock* clock);

  /* The parameters that create takes, and their number; of all instances, so that it is known too where none
   * can be made for want of one. They live for ever. With it tandem refuses what is not among them, or is no
   * number, before it calls create; create puts in what is not given. NULL, or a number of 0: create takes
   * any, and refuses what it does not know. */
  const tandem_parameter* (*parameters)(int32_t* count);

  /* By output, its usual magnitude in its unit, above 0: a run that grows far beyond it ends. NULL: each
   * is 1. It belongs to the subsystem and lives until `destroy`. */
  const double* (*nominal)(void* self);
} tandem_subsystem_api;

/* sizeof the table before serialize_state came: the least that table_size may be. */
#define TANDEM_SHORTEST_TABLE offsetof(tandem_subsystem_api, serialize_state)

/* The one symbol that a shared library exports: a function of this type, named tandem_subsystem unless the
 * URI names another (entry=NAME). */
typedef const tandem_subsystem_api* (*tandem_subsystem_entry)(void);

#ifdef __cplusplus
}
#endif
#endif
