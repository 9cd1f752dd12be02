/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* A model in Octave as a subsystem. (One file, as each call of the table is a few lines about one struct.) */
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
  double* nominal;
  double h, offset, latency; /* the last two of a sampled one */
  double origin;             /* of the grid: the start, or the first instant */
  grid grid;
  mxArray* saved[MAX_SAVED]; /* states; a state is a value, so that a copy of it is saved */
  grid saved_grid[MAX_SAVED];
  char error[1024];
} model;

/* During the call: the function that is served, and what it takes. */
static mxArray *maker, *declared_cells;
static tandem_parameter* declared;

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

static tandem_status create(const char* parameters, void** self) {
  model* const s = calloc(1, sizeof *s);
  mxArray* arguments[4];
  tandem_status status;
  if (!(*self = s)) return TANDEM_INTERNAL;
  arguments[0] = mxCreateString("__tandem_model__");
  arguments[1] = maker;
  arguments[2] = declared_cells;
  arguments[3] = mxCreateString(parameters);
  status = call(s, 4, arguments, &s->user);
  mxDestroyArray(arguments[0]);
  mxDestroyArray(arguments[3]);
  if (status != TANDEM_OK) return TANDEM_INVALID_ARGUMENT;
  s->h = mxGetScalar(field(s, "h"));
  s->offset = mxGetScalar(field(s, "offset"));
  s->latency = mxGetScalar(field(s, "latency"));
  s->nominal = nominal_of(s->user);
  return read_info(s->user, &s->info) && s->nominal ? TANDEM_OK : refuse(s, TANDEM_INTERNAL, "no memory%s", "");
}

/* The arrays of Octave go with the call of "serve". */
static void destroy(void* self) {
  model* const s = self;
  free_info(&s->info);
  free(s->nominal);
  free(s);
}
static const tandem_info* info(void* self) { return &((model*)self)->info; }
static const double* nominal(void* self) { return ((model*)self)->nominal; }
static const char* last_error(void* self) { return ((model*)self)->error; }

/* Width within which two times are the same, as subsystem.h says. */
static double width(const model* s, double a, double b) {
  return 6.0 * DBL_EPSILON * fmax(fmax(fabs(a), fabs(b)), fabs(s->origin));
}

static int is_sampled(const model* s) { return (s->info.abilities & TANDEM_SAMPLED) != 0; }

/* Puts what values (state) gives; of a sampled one with feedthrough values (state, u), at the start u is [].
 */
static tandem_status put_values(model* s, const double* u, size_t inputs, double* to, size_t wanted) {
  const int with_inputs = is_sampled(s) && s->info.feedthrough_count > 0;
  mxArray *values, *arguments[3] = {field(s, "values"), s->state, with_inputs ? row_of(u, inputs) : NULL};
  const tandem_status called = call(s, with_inputs ? 3 : 2, arguments, &values);
  tandem_status status = called;
  if (with_inputs) mxDestroyArray(arguments[2]);
  if (called != TANDEM_OK) return called;
  if (!mxIsDouble(values) || mxIsComplex(values) || mxIsSparse(values) ||
      mxGetNumberOfElements(values) != wanted) {
    snprintf(s->error, sizeof s->error,
             "values (state) gives %zu numbers; allowed are %zu: outputs, then derivatives",
             mxGetNumberOfElements(values), wanted);
    status = TANDEM_INVALID_ARGUMENT;
  } else {
    memcpy(to, mxGetPr(values), wanted * sizeof *to);
  }
  mxDestroyArray(values);
  return status;
}

static tandem_status append(model* s, tandem_samples* y) {
  double* const row = y->rows + y->size * y->stride;
  const tandem_status status = put_values(s, NULL, 0, row + 2, (size_t)y->stride - 2);
  row[0] = s->grid.time;
  row[1] = 0.0;
  y->size += status == TANDEM_OK;
  return status;
}

static void put_state(model* s, mxArray* state) {
  if (s->state) mxDestroyArray(s->state);
  s->state = state;
}

static tandem_status step(model* s, double begin, double end, double length, mxArray* u) {
  mxArray *state, *arguments[6];
  tandem_status status;
  int k;
  arguments[0] = field(s, "step");
  arguments[1] = s->state;
  arguments[2] = mxCreateDoubleScalar(begin);
  arguments[3] = mxCreateDoubleScalar(end);
  arguments[4] = mxCreateDoubleScalar(length);
  arguments[5] = u;
  status = call(s, 6, arguments, &state);
  for (k = 2; k < 5; ++k) mxDestroyArray(arguments[k]);
  if (status != TANDEM_OK) return status;
  put_state(s, state);
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
  s->grid.time = t_start;
  s->origin = t_start + s->offset;
  s->grid.node = is_sampled(s) ? 0 : 1;
  s->grid.next = s->origin + (double)s->grid.node * s->h;
  s->grid.cut = 0;
  if ((status = append(s, y)) != TANDEM_OK) return status;
  return tell(s, TANDEM_STOP_LIMIT, clock);
}

/* Where the next own step ends, or the next instant is, once it stands at grid.next. */
static double after_next(const model* s) {
  return s->origin + (double)(s->grid.node + 1) * s->h; /* multiplied, never accumulated */
}

static void move_on(model* s) {
  s->grid.time = s->grid.next;
  s->grid.next = after_next(s);
  ++s->grid.node;
  s->grid.cut = 0;
}

/* One own step, or what the limit leaves of it; *more is 0 if there is none up to the limit. */
static tandem_status take_step(model* s, double t_limit, int32_t land, mxArray* u, int* more) {
  const double begin = s->grid.time;
  tandem_status status;
  if (s->grid.next <= t_limit + width(s, s->grid.next, t_limit)) {
    status = step(s, begin, s->grid.next, s->grid.cut ? s->grid.next - begin : s->h, u);
    if (status == TANDEM_OK) move_on(s);
    return status;
  }
  *more = land && begin < t_limit - width(s, begin, t_limit);
  if (!*more || (status = step(s, begin, t_limit, t_limit - begin, u)) != TANDEM_OK)
    return *more ? status : TANDEM_OK;
  s->grid.time = t_limit;
  s->grid.cut = 1;
  return TANDEM_OK;
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

static tandem_status sampling(void* self, double* period, double* latency) {
  *period = ((model*)self)->h;
  *latency = ((model*)self)->latency;
  return TANDEM_OK;
}

/* From one instant to the next, on inputs that hold. */
static tandem_status go_on(model* s, double t, const double* u) {
  mxArray* const inputs = constants_as_array(u, inputs_of(&s->info), t);
  const tandem_status status = step(s, t, after_next(s), s->h, inputs);
  mxDestroyArray(inputs);
  if (status == TANDEM_OK) move_on(s);
  return status;
}

static tandem_status sample(void* self, double t, int32_t parts, const double* u, double* y,
                            tandem_clock* clock) {
  model* const s = self;
  const size_t inputs = inputs_of(&s->info), outputs = (size_t)s->info.output_count;
  tandem_status status = TANDEM_OK;
  if (parts & TANDEM_SAMPLE_OUTPUTS) status = put_values(s, u, inputs, y, outputs);
  if (status == TANDEM_OK && (parts & TANDEM_SAMPLE_STATES)) status = go_on(s, t, u);
  return status == TANDEM_OK ? tell(s, TANDEM_STOP_LIMIT, clock) : status;
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

static const tandem_parameter* parameters_of(int32_t* count) {
  *count = (int32_t)mxGetM(declared_cells);
  return declared;
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
    .sampling = sampling,
    .sample = sample,
    .parameters = parameters_of,
    .nominal = nominal,
};

const tandem_subsystem_api* octave_model(mxArray* make, mxArray* parameters) {
  maker = make;
  declared_cells = parameters;
  declared = parameters_in(parameters);
  return &model_api;
}
