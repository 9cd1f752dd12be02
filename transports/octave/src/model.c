/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "octave_peer.h"

enum { MAX_SAVED = 64 };

typedef struct grid {
  double time, next;
  int64_t node; /* number of the node `next` */
  int cut;      /* the last step ended before its node */
} grid;

typedef struct model {
  mxArray *user, *state;
  tandem_info info;
  double h, t_start;
  grid grid;
  mxArray* saved[MAX_SAVED]; /* states; a state is a value, so that a copy of it is saved */
  grid saved_grid[MAX_SAVED];
  char error[1024];
} model;

static mxArray* maker; /* the function that is served, during the call */

static tandem_status refuse(model* s, tandem_status status, const char* format, const char* what) {
  snprintf(s->error, sizeof s->error, format, what);
  return status;
}

/* [message, result] = __tandem_call__ (arguments{:}); the arguments without a name are freed. */
static tandem_status call(model* s, int count, mxArray** arguments, mxArray** result) {
  mxArray* out[2] = {NULL, NULL};
  mxArray* const trapped = mexCallMATLABWithTrap(2, out, count, arguments, "__tandem_call__");
  char* message = trapped || !out[0] ? NULL : mxArrayToString(out[0]);
  tandem_status status = TANDEM_OK;
  if (!message || *message)
    status = refuse(s, TANDEM_INTERNAL, "%s", message ? message : "Octave can't call the model");
  mxFree(message);
  if (trapped) mxDestroyArray(trapped);
  if (out[0]) mxDestroyArray(out[0]);
  *result = status == TANDEM_OK ? out[1] : NULL;
  if (status != TANDEM_OK && out[1]) mxDestroyArray(out[1]);
  return status;
}

static mxArray* field(const model* s, const char* name) { return mxGetField(s->user, 0, name); }

static mxArray* row_of(const double* values, size_t count) {
  mxArray* const row = mxCreateDoubleMatrix(1, count, mxREAL);
  if (count) memcpy(mxGetPr(row), values, count * sizeof *values);
  return row;
}

static size_t inputs_of(const tandem_info* info) { return (size_t)info->input_count; }

/* A row of a cell array for each port: name, unit; of an output also its number of derivatives, of an input
 * its start. */
static tandem_port* ports_of(const mxArray* cells, int32_t* count, int inputs) {
  const size_t rows = mxGetM(cells);
  tandem_port* const ports = calloc(rows + 1, sizeof *ports);
  size_t k;
  *count = (int32_t)rows;
  for (k = 0; ports && k < rows; ++k) {
    const double number = mxGetScalar(mxGetCell(cells, k + 2 * rows));
    ports[k].name = mxArrayToString(mxGetCell(cells, k));
    ports[k].unit = mxArrayToString(mxGetCell(cells, k + rows));
    ports[k].size = 1;
    ports[k].derivatives = inputs ? 0 : (int32_t)number;
    ports[k].start = inputs ? number : NAN;
  }
  return ports;
}

static tandem_status take_info(model* s) {
  const mxArray* const pairs = field(s, "feedthrough");
  const size_t count = mxGetM(pairs);
  tandem_feedthrough* const f = calloc(count + 1, sizeof *f);
  size_t k;
  for (k = 0; f && k < count; ++k) {
    f[k].output = (int32_t)mxGetPr(pairs)[k] - 1;
    f[k].input = (int32_t)mxGetPr(pairs)[k + count] - 1;
  }
  s->info.name = mxArrayToString(field(s, "name"));
  s->info.abilities = TANDEM_LANDS | TANDEM_SAVES_STATE | TANDEM_RESTARTS;
  s->info.inputs = ports_of(field(s, "inputs"), &s->info.input_count, 1);
  s->info.outputs = ports_of(field(s, "outputs"), &s->info.output_count, 0);
  s->info.feedthrough = f;
  s->info.feedthrough_count = (int32_t)count;
  s->h = mxGetScalar(field(s, "h"));
  return s->info.name && s->info.inputs && s->info.outputs && f
             ? TANDEM_OK
             : refuse(s, TANDEM_INTERNAL, "no memory%s", "");
}

static tandem_status create(const char* parameters, void** self) {
  model* const s = calloc(1, sizeof *s);
  mxArray* arguments[3];
  tandem_status status;
  if (!(*self = s)) return TANDEM_INTERNAL;
  arguments[0] = mxCreateString("__tandem_model__");
  arguments[1] = maker;
  arguments[2] = mxCreateString(parameters);
  status = call(s, 3, arguments, &s->user);
  mxDestroyArray(arguments[0]);
  mxDestroyArray(arguments[2]);
  if (status != TANDEM_OK) return TANDEM_INVALID_ARGUMENT;
  return take_info(s);
}

/* The arrays of Octave go with the call of "serve". */
static void destroy(void* self) {
  model* const s = self;
  free((void*)s->info.inputs);
  free((void*)s->info.outputs);
  free((void*)s->info.feedthrough);
  free(s);
}
static const tandem_info* info(void* self) { return &((model*)self)->info; }
static const char* last_error(void* self) { return ((model*)self)->error; }

/* Width within which two times are the same, as subsystem.h says. */
static double width(const model* s, double a, double b) {
  return 6.0 * DBL_EPSILON * fmax(fmax(fabs(a), fabs(b)), fabs(s->t_start));
}

/* Appends what values (state) gives. */
static tandem_status append(model* s, tandem_samples* y) {
  double* const row = y->rows + y->size * y->stride;
  const size_t wanted = (size_t)y->stride - 2;
  mxArray *values, *arguments[2];
  tandem_status status;
  arguments[0] = field(s, "values");
  arguments[1] = s->state;
  if ((status = call(s, 2, arguments, &values)) != TANDEM_OK) return status;
  if (!mxIsDouble(values) || mxIsComplex(values) || mxIsSparse(values) ||
      mxGetNumberOfElements(values) != wanted) {
    snprintf(s->error, sizeof s->error,
             "values (state) gives %zu numbers; allowed are %zu: outputs, then derivatives",
             mxGetNumberOfElements(values), wanted);
    status = TANDEM_INVALID_ARGUMENT;
  } else {
    row[0] = s->grid.time;
    row[1] = 0.0;
    memcpy(row + 2, mxGetPr(values), wanted * sizeof *row);
    ++y->size;
  }
  mxDestroyArray(values);
  return status;
}

static void put_state(model* s, mxArray* state) {
  if (s->state) mxDestroyArray(s->state);
  s->state = state;
}

static tandem_status step(model* s, double end, mxArray* u) {
  const double length = end == s->grid.next && !s->grid.cut ? s->h : end - s->grid.time;
  mxArray *state, *arguments[6];
  tandem_status status;
  int k;
  arguments[0] = field(s, "step");
  arguments[1] = s->state;
  arguments[2] = mxCreateDoubleScalar(s->grid.time);
  arguments[3] = mxCreateDoubleScalar(end);
  arguments[4] = mxCreateDoubleScalar(length);
  arguments[5] = u;
  status = call(s, 6, arguments, &state);
  for (k = 2; k < 5; ++k) mxDestroyArray(arguments[k]);
  if (status != TANDEM_OK) return status;
  put_state(s, state);
  s->grid.time = end;
  return TANDEM_OK;
}

static tandem_status tell(const model* s, tandem_stop stop, tandem_clock* clock) {
  clock->time = s->grid.time;
  clock->next_time = s->grid.next;
  clock->stop = stop;
  clock->reserved = 0;
  return TANDEM_OK;
}

static tandem_status initialize(void* self, double t_start, double t_stop, const double* u0,
                                tandem_samples* y, tandem_clock* clock) {
  model* const s = self;
  mxArray *state, *arguments[3];
  tandem_status status;
  (void)t_stop;
  arguments[0] = field(s, "start");
  arguments[1] = mxCreateDoubleScalar(t_start);
  arguments[2] = row_of(u0, inputs_of(&s->info));
  status = call(s, 3, arguments, &state);
  mxDestroyArray(arguments[1]);
  mxDestroyArray(arguments[2]);
  if (status != TANDEM_OK) return status;
  put_state(s, state);
  s->t_start = s->grid.time = t_start;
  s->grid.node = 1;
  s->grid.next = t_start + s->h;
  s->grid.cut = 0;
  if ((status = append(s, y)) != TANDEM_OK) return status;
  return tell(s, TANDEM_STOP_LIMIT, clock);
}

/* One own step, or what the limit leaves of it; *more is 0 if there is none up to the limit. */
static tandem_status take_step(model* s, double t_limit, int32_t land, mxArray* u, int* more) {
  tandem_status status;
  if (s->grid.next <= t_limit + width(s, s->grid.next, t_limit)) {
    if ((status = step(s, s->grid.next, u)) != TANDEM_OK) return status;
    s->grid.next = s->t_start + (double)++s->grid.node * s->h; /* multiplied, never accumulated */
    s->grid.cut = 0;
    return TANDEM_OK;
  }
  *more = land && s->grid.time < t_limit - width(s, s->grid.time, t_limit);
  if (!*more) return TANDEM_OK;
  s->grid.cut = 1;
  return step(s, t_limit, u);
}

static tandem_status advance(void* self, double t_limit, int32_t land, const tandem_signal* u,
                             tandem_samples* y, tandem_clock* clock) {
  model* const s = self;
  mxArray* const inputs = inputs_as_array(u, inputs_of(&s->info));
  tandem_status status = TANDEM_OK;
  int more = 1;
  if (!inputs) return refuse(s, TANDEM_NOT_SUPPORTED, "the inputs have more than 131072 segments%s", "");
  while (status == TANDEM_OK && more && y->size < y->capacity) {
    status = take_step(s, t_limit, land, inputs, &more);
    if (status == TANDEM_OK && more) status = append(s, y);
  }
  mxDestroyArray(inputs);
  if (status != TANDEM_OK) return status;
  return tell(s, more ? TANDEM_STOP_SAMPLES_FULL : TANDEM_STOP_LIMIT, clock);
}

static tandem_status save_state(void* self, int64_t* id) {
  model* const s = self;
  int k = 0;
  while (k < MAX_SAVED && s->saved[k]) ++k;
  if (k == MAX_SAVED) return refuse(s, TANDEM_NOT_SUPPORTED, "64 states are saved, the most%s", "");
  s->saved[k] = mxDuplicateArray(s->state);
  s->saved_grid[k] = s->grid;
  *id = k;
  return TANDEM_OK;
}

static int is_saved(model* s, int64_t id) {
  if (id >= 0 && id < MAX_SAVED && s->saved[id]) return 1;
  snprintf(s->error, sizeof s->error, "no saved state %lld", (long long)id);
  return 0;
}

static tandem_status restore_state(void* self, int64_t id, tandem_clock* clock) {
  model* const s = self;
  if (!is_saved(s, id)) return TANDEM_INVALID_ARGUMENT;
  put_state(s, mxDuplicateArray(s->saved[id]));
  s->grid = s->saved_grid[id];
  return tell(s, TANDEM_STOP_LIMIT, clock);
}

static tandem_status release_state(void* self, int64_t id) {
  model* const s = self;
  if (!is_saved(s, id)) return TANDEM_INVALID_ARGUMENT;
  mxDestroyArray(s->saved[id]);
  s->saved[id] = NULL;
  return TANDEM_OK;
}

static const tandem_subsystem_api model_api = {
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
};

const tandem_subsystem_api* octave_model(mxArray* make) {
  maker = make;
  return &model_api;
}
