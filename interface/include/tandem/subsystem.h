/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* The subsystem contract in C99. A subsystem integrates itself with its own step; the coordinator tells it up
 * to where, and gives every input as a function of time. Data in, data out: nothing calls back, so the same
 * contract holds in one process, in a shared library and over a socket.
 *
 * Units are SI (time in s) unless a port says otherwise. Numbers are IEEE doubles. Inputs are functions of
 * time: tandem/signal.h.
 *
 * Order of calls on one instance:
 * 1. create
 * 2. info
 * 3. initialize, again as often as needed
 * 4. advance, advance, ... or, of a sampled subsystem, sample, sample, ...
 * 5. destroy
 *
 * After the first `advance`, `initialize` may be called again only with TANDEM_RESTARTS. Calls on one
 * instance never overlap; different instances may be called from different threads.
 *
 * Ownership: what `info` points to belongs to the subsystem and lives until `destroy`. Signals and samples
 * belong to the caller and are valid during the call only.
 *
 * Errors: a function returns a tandem_status; `last_error` then gives a sentence, valid until the next call
 * on that instance. No function may throw or longjmp through its caller. */
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

/* Rows in the caller's memory. Append at rows + size * stride and count up `size`; never rewrite a row;
 * return early with TANDEM_STOP_SAMPLES_FULL when size == capacity. A row is `stride` doubles:
 * - time [s];
 * - jump: 1 where nothing before this row may be fitted together with it, else 0;
 * - the outputs;
 * - their first time derivatives, their second ones, as many blocks as tandem_info says (0 where a port has
 *   fewer). */
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

/* What a sampled subsystem is to do at an instant. */
enum {
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

/* The table of functions. New functions are added at its end only; a table_size that ends before one says
 * that it is not there. Parameters that mean the same in all functions:
 * - self: the instance that create gave.
 * - clock: takes where it stands, its next_time and why it returned. */
typedef struct tandem_subsystem_api {
  uint32_t abi_version; /* TANDEM_ABI_VERSION */
  uint32_t table_size;  /* sizeof(tandem_subsystem_api) of the one who built it */

  /* Makes a new instance.
   * - parameters: "key=value" pairs joined by '&', or "".
   * - self: takes the instance. On failure *self may still be an instance that last_error can be asked about;
   *   it is destroyed in any case if not NULL. */
  tandem_status (*create)(const char* parameters, void** self);
  void (*destroy)(void* self);
  const tandem_info* (*info)(void* self);
  const char* (*last_error)(void* self);

  /* Puts the state at t_start and appends the first sample. Outputs without feedthrough from an unknown input
   * must come back finite all the same. A sampled subsystem gives the outputs that hold before its first
   * instant; that instant is its next_time. Of several calls the sample of the last one counts.
   * - t_start [s]: the begin of the run. The first instant of a sampled subsystem is t_start or later.
   * - t_stop [s]: the end of the run. No call asks it to go past that.
   * - u0: one value per scalar input, in the unit of its port; NaN where it is not known yet.
   * - y: takes the first sample. Precondition: room for one row. */
  tandem_status (*initialize)(void* self, double t_start, double t_stop, const double* u0, tandem_samples* y,
                              tandem_clock* clock);

  /* Takes own steps for as long as they end at or before t_limit, and appends one row for each. The time of
   * the clock is then the time of the last row.
   * - t_limit [s]: where the last step ends at the latest. Compare times with this tolerance:
   *   6 DBL_EPSILON max(|t|, |t_start|). A strict comparison costs extra calls.
   * - land: other than 0: the last step is cut so that it ends at t_limit; the grid of own steps stays as it
   *   was. Precondition of that: TANDEM_LANDS.
   * - u: one signal per scalar input, covering [time, t_limit], in the unit of its port. At the begin of a
   *   call it may differ from what it was at the end of the last one.
   * - y: takes a row for each step. Precondition: room for two rows with TANDEM_EVENTS. */
  tandem_status (*advance)(void* self, double t_limit, int32_t land, const tandem_signal* u,
                           tandem_samples* y, tandem_clock* clock);

  /* With TANDEM_SAVES_STATE only, else NULL: copies the state; stands again where it stood when the state was
   * saved; forgets a saved state.
   * - id: the saved state; save_state puts it there. It stays valid until released or destroyed. */
  tandem_status (*save_state)(void* self, int64_t* id);
  tandem_status (*restore_state)(void* self, int64_t id, tandem_clock* clock);
  tandem_status (*release_state)(void* self, int64_t id);

  /* With TANDEM_SERIALIZES_STATE (beside TANDEM_SAVES_STATE) only, else NULL: gives a saved state as bytes,
   * and makes a saved state from bytes. The bytes are for an instance that is made with the same parameters
   * and initialized with the same span and inputs, in this process or another. Restored there, it goes on
   * with the same bits as this one does. With this ability save_state leaves what follows as it would be
   * without it.
   * - id: the saved state; deserialize_state puts it there.
   * - bytes: of serialize_state they belong to the subsystem and are valid until the next call on that
   *   instance. To deserialize_state bytes of another subsystem, or not whole, are TANDEM_INVALID_ARGUMENT,
   *   where that can be told.
   * - size: their number. */
  tandem_status (*serialize_state)(void* self, int64_t id, const void** bytes, int64_t* size);
  tandem_status (*deserialize_state)(void* self, const void* bytes, int64_t size, int64_t* id);

  /* With TANDEM_HOLDS only, else NULL: a flag by output, 1 if it is held: constant from each of its samples,
   * that instant included, to the next. It belongs to the subsystem and lives until `destroy`. */
  const int32_t* (*held)(void* self);

  /* With TANDEM_SAMPLED only, else NULL; `advance` may then be NULL, as nobody calls it. Gives two constants.
   * - period [s]: the least time between two instants, above 0.
   * - latency [s]: the outputs change this long after each instant, 0 or more. */
  tandem_status (*sampling)(void* self, double* period, double* latency);
  /* With TANDEM_SAMPLED only, else NULL: acts at an instant.
   * - t [s]: the instant. Precondition: it is its next_time.
   * - parts: TANDEM_SAMPLE_... or both.
   * - u: one value per scalar input at t. Inputs from other sampled subsystems have what is new at t. The
   *   values for the states are the values for the outputs, but for inputs that do not feed through.
   * - y: one value per scalar output, to be given with the outputs. They hold from t + latency until the next
   *   ones do.
   * - clock: takes where it stands (t) and its next instant. */
  tandem_status (*sample)(void* self, double t, int32_t parts, const double* u, double* y,
                          tandem_clock* clock);

  /* The parameters that create takes. They are of all instances, so that they are known too where none can be
   * made for want of one, and live for ever. With them tandem refuses what is not among them, or is no
   * number, before it calls create; create puts in what is not given. NULL, or a number of 0: create takes
   * any, and refuses what it does not know.
   * - count: takes their number. */
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
