/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* What the functions of this package stand on, a MEX file over tandem/peer.h:
 *   status = __tandem__ ("serve", make, ARGUMENTS)
 *   handle = __tandem__ ("connect", uri, allow_plaintext)
 *   ... = __tandem__ ("info" | "initialize" | "advance" | "save" | "restore" | "release" | "close", handle,
 * ...) */
#define _DEFAULT_SOURCE /* sigaction, kill */
#include <float.h>
#include <math.h>
#include <mex.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include "tandem/peer.h"

enum { MAX_SAVED = 64, MAX_HANDLES = 64, ROOM = 1000 };

/* ---- A model in Octave as a subsystem: what __tandem_model__.m makes of the user's struct ---- */

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

/* A struct array with an element for each input: fields end, origin (a column each) and c (n x 6). */
static mxArray* inputs_as_array(const tandem_signal* u, size_t count) {
  static const char* names[] = {"end", "origin", "c"};
  mxArray* const all = mxCreateStructMatrix(1, count, 3, names);
  size_t i, j, k;
  for (i = 0; i < count; ++i) {
    const size_t n = (size_t)u[i].count;
    mxArray* const end = mxCreateDoubleMatrix(n, 1, mxREAL);
    mxArray* const origin = mxCreateDoubleMatrix(n, 1, mxREAL);
    mxArray* const c = mxCreateDoubleMatrix(n, TANDEM_MAX_COEFFICIENTS, mxREAL);
    for (k = 0; k < n; ++k) {
      mxGetPr(end)[k] = u[i].segments[k].end;
      mxGetPr(origin)[k] = u[i].segments[k].origin;
      for (j = 0; j < TANDEM_MAX_COEFFICIENTS; ++j) mxGetPr(c)[k + j * n] = u[i].segments[k].c[j];
    }
    mxSetField(all, i, "end", end);
    mxSetField(all, i, "origin", origin);
    mxSetField(all, i, "c", c);
  }
  return all;
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

static const tandem_subsystem_api model_api = {TANDEM_ABI_VERSION,
                                               sizeof(tandem_subsystem_api),
                                               create,
                                               destroy,
                                               info,
                                               last_error,
                                               initialize,
                                               advance,
                                               save_state,
                                               restore_state,
                                               release_state,
                                               NULL,
                                               NULL};

static volatile sig_atomic_t told; /* the signal that has come */
static void note(int number) { told = number; }

/* The status of the process that serves, to which signals are handed on. */
static int wait_for_server(pid_t server) {
  struct sigaction action, terminate, interrupt;
  sigset_t both, before;
  int status = 0;
  memset(&action, 0, sizeof action);
  action.sa_handler = note;
  told = 0;
  sigaction(SIGTERM, &action, &terminate);
  sigaction(SIGINT, &action, &interrupt);
  sigemptyset(&both);
  sigaddset(&both, SIGTERM);
  sigaddset(&both, SIGINT);
  sigprocmask(SIG_UNBLOCK, &both, &before);
  while (waitpid(server, &status, WNOHANG) == 0) {
    if (told) kill(server, told);
    poll(NULL, 0, 10);
  }
  sigaction(SIGTERM, &terminate, NULL);
  sigaction(SIGINT, &interrupt, NULL);
  sigprocmask(SIG_SETMASK, &before, NULL);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

/* Sessions begin and end in a process without Octave's threads: one of them waits for all signals, and where
 * a session's end wakes it, takes the one that is to end the server. */
static int serve_apart(int count, char** words) {
  const pid_t parent = getpid();
  pid_t server;
  fflush(NULL);
  server = fork();
  if (server < 0) mexErrMsgTxt("tandem_serve: no process for the server");
  if (server > 0) return wait_for_server(server);
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGTERM); /* ended with this process, also if it is killed */
#endif
  if (getppid() != parent) _exit(0);
  {
    const int status = tandem_serve(&model_api, count, words);
    fflush(NULL);
    _exit(status);
  }
}

/* A session of spawn: is alone, and ends with its socket. */
static void serve(mxArray** out, int count, const mxArray** in) {
  char* words[18] = {"tandem_serve"};
  int k;
  if (count > 18) mexErrMsgTxt("tandem_serve: too many arguments");
  for (k = 1; k < count; ++k) words[k] = mxArrayToString(in[k]);
  maker = (mxArray*)in[0];
  out[0] = mxCreateDoubleScalar(getenv("TANDEM_FD") ? tandem_serve(&model_api, count, words)
                                                    : serve_apart(count, words));
}

/* ---- A subsystem elsewhere, driven from Octave ---- */

static void* handles[MAX_HANDLES];

static void close_all(void) {
  int k;
  for (k = 0; k < MAX_HANDLES; ++k)
    if (handles[k]) tandem_remote()->destroy(handles[k]);
  memset(handles, 0, sizeof handles);
}

/* Octave's error with the sentence; the names of the codes are those of the contract. */
static void fail(tandem_status status, const char* sentence) {
  static const char* const codes[] = {"tandem:ok",          "tandem:invalid_argument", "tandem:not_supported",
                                      "tandem:wrong_state", "tandem:numerical",        "tandem:input_output",
                                      "tandem:internal"};
  mexErrMsgIdAndTxt(codes[status], "%s", sentence);
}

static void check(void* self, tandem_status status) {
  if (status != TANDEM_OK) fail(status, tandem_remote()->last_error(self));
}

static int index_of(const mxArray* handle) {
  const double k = mxIsDouble(handle) && mxGetNumberOfElements(handle) == 1 ? mxGetScalar(handle) : 0.0;
  if (!(k >= 1 && k <= MAX_HANDLES && k == floor(k) && handles[(int)k - 1]))
    mexErrMsgIdAndTxt("tandem:invalid_argument", "this is no connection that is open");
  return (int)k - 1;
}

static void connect_to(mxArray** out, const mxArray** in) {
  char* const uri = mxArrayToString(in[0]);
  char error[2048];
  void* self;
  tandem_status status;
  int k = 0;
  while (k < MAX_HANDLES && handles[k]) ++k;
  if (k == MAX_HANDLES) mexErrMsgIdAndTxt("tandem:not_supported", "64 connections are open, the most");
  mexAtExit(close_all);
  status = tandem_connect(uri, mxGetScalar(in[1]) != 0.0, &self);
  mxFree(uri);
  if (!self) fail(status, "no memory");
  if (status != TANDEM_OK) {
    snprintf(error, sizeof error, "%s", tandem_remote()->last_error(self));
    tandem_remote()->destroy(self);
    fail(status, error);
  }
  handles[k] = self;
  out[0] = mxCreateDoubleScalar(k + 1);
}

static mxArray* array_of_ports(const tandem_port* ports, int32_t count) {
  static const char* names[] = {"name", "unit", "size", "derivatives", "start"};
  mxArray* const all = mxCreateStructMatrix(1, (mwSize)count, 5, names);
  mwIndex k;
  for (k = 0; k < (mwIndex)count; ++k) {
    mxSetField(all, k, "name", mxCreateString(ports[k].name));
    mxSetField(all, k, "unit", mxCreateString(ports[k].unit));
    mxSetField(all, k, "size", mxCreateDoubleScalar(ports[k].size));
    mxSetField(all, k, "derivatives", mxCreateDoubleScalar(ports[k].derivatives));
    mxSetField(all, k, "start", mxCreateDoubleScalar(ports[k].start));
  }
  return all;
}

static mxArray* info_as_struct(const tandem_info* i) {
  static const char* names[] = {"name", "inputs", "outputs", "feedthrough", "abilities"};
  mxArray* const all = mxCreateStructMatrix(1, 1, 5, names);
  mxArray* const pairs = mxCreateDoubleMatrix((mwSize)i->feedthrough_count, 2, mxREAL);
  int32_t k;
  for (k = 0; k < i->feedthrough_count; ++k) {
    mxGetPr(pairs)[k] = i->feedthrough[k].output + 1;
    mxGetPr(pairs)[k + i->feedthrough_count] = i->feedthrough[k].input + 1;
  }
  mxSetField(all, 0, "name", mxCreateString(i->name));
  mxSetField(all, 0, "inputs", array_of_ports(i->inputs, i->input_count));
  mxSetField(all, 0, "outputs", array_of_ports(i->outputs, i->output_count));
  mxSetField(all, 0, "feedthrough", pairs);
  mxSetField(all, 0, "abilities", mxCreateDoubleScalar(i->abilities));
  return all;
}

static mxArray* clock_as_struct(const tandem_clock* clock) {
  static const char* names[] = {"time", "next_time", "stop"};
  static const char* const stops[] = {"limit", "event", "samples_full", "finished"};
  mxArray* const all = mxCreateStructMatrix(1, 1, 3, names);
  mxSetField(all, 0, "time", mxCreateDoubleScalar(clock->time));
  mxSetField(all, 0, "next_time", mxCreateDoubleScalar(clock->next_time));
  mxSetField(all, 0, "stop", mxCreateString(stops[clock->stop]));
  return all;
}

static tandem_samples new_samples(const tandem_info* i) {
  tandem_samples y;
  y.stride = tandem_row_size(i);
  y.capacity = ROOM;
  y.size = 0;
  y.rows = mxMalloc((size_t)(y.stride * y.capacity) * sizeof(double)); /* Octave's, freed in any case */
  return y;
}

static void give(mxArray** out, int wanted, const tandem_samples* y, const tandem_clock* clock) {
  int64_t i, k;
  out[0] = clock_as_struct(clock);
  if (wanted < 2) return;
  out[1] = mxCreateDoubleMatrix((mwSize)y->size, (mwSize)y->stride, mxREAL);
  for (i = 0; i < y->size; ++i)
    for (k = 0; k < y->stride; ++k) mxGetPr(out[1])[i + k * y->size] = y->rows[i * y->stride + k];
}

static int64_t scalars(const tandem_info* i) {
  int64_t count = 0;
  int32_t k;
  for (k = 0; k < i->input_count; ++k) count += i->inputs[k].size;
  return count;
}

static void start(void* self, int wanted, mxArray** out, const mxArray** in) {
  const tandem_info* const i = tandem_remote()->info(self);
  tandem_samples y = new_samples(i);
  tandem_clock clock;
  if (!mxIsDouble(in[2]) || (int64_t)mxGetNumberOfElements(in[2]) != scalars(i))
    mexErrMsgIdAndTxt("tandem:invalid_argument", "u0 has %d numbers; allowed are %d",
                      (int)mxGetNumberOfElements(in[2]), (int)scalars(i));
  check(self, tandem_remote()->initialize(self, mxGetScalar(in[0]), mxGetScalar(in[1]), mxGetPr(in[2]), &y,
                                          &clock));
  give(out, wanted, &y, &clock);
}

/* Element k of the struct array of inputs, as tandem_signal.m makes it. */
static tandem_signal signal_of(const mxArray* u, mwIndex k) {
  const mxArray* const end = mxGetField(u, k, "end");
  const mxArray* const origin = mxGetField(u, k, "origin");
  const mxArray* const c = mxGetField(u, k, "c");
  tandem_signal s = {NULL, 0, TANDEM_MAX_COEFFICIENTS - 1, NULL};
  tandem_segment* segments;
  size_t i, j, n = 0;
  if (!end || !origin || !c || !mxIsDouble(end) || !mxIsDouble(origin) || !mxIsDouble(c) ||
      (n = mxGetNumberOfElements(end)) == 0 || mxGetNumberOfElements(origin) != n || mxGetM(c) != n ||
      mxGetN(c) != TANDEM_MAX_COEFFICIENTS)
    mexErrMsgIdAndTxt("tandem:invalid_argument", "input %d is not of the form of tandem_signal", (int)k + 1);
  segments = mxCalloc(n, sizeof *segments);
  for (i = 0; i < n; ++i) {
    segments[i].end = mxGetPr(end)[i];
    segments[i].origin = mxGetPr(origin)[i];
    for (j = 0; j < TANDEM_MAX_COEFFICIENTS; ++j) segments[i].c[j] = mxGetPr(c)[i + j * n];
  }
  s.segments = segments;
  s.count = (int32_t)n;
  return s;
}

static void go_on(void* self, int wanted, mxArray** out, const mxArray** in) {
  const tandem_info* const i = tandem_remote()->info(self);
  const int64_t count = scalars(i);
  tandem_samples y = new_samples(i);
  tandem_clock clock;
  tandem_signal* u;
  int64_t k;
  if (count && (!mxIsStruct(in[1]) || (int64_t)mxGetNumberOfElements(in[1]) != count))
    mexErrMsgIdAndTxt("tandem:invalid_argument", "u is no struct array of %d elements, one for each input",
                      (int)count);
  u = mxCalloc((size_t)count + 1, sizeof *u);
  for (k = 0; k < count; ++k) u[k] = signal_of(in[1], (mwIndex)k);
  check(self, tandem_remote()->advance(self, mxGetScalar(in[0]), mxGetScalar(in[2]) != 0.0, u, &y, &clock));
  give(out, wanted, &y, &clock);
}

static void use_state(void* self, const char* what, mxArray** out, const mxArray** in) {
  const tandem_subsystem_api* const api = tandem_remote();
  int64_t id = strcmp(what, "save") == 0 ? 0 : (int64_t)mxGetScalar(in[0]);
  tandem_clock clock;
  if (strcmp(what, "save") == 0) {
    check(self, api->save_state(self, &id));
    out[0] = mxCreateDoubleScalar((double)id);
  } else if (strcmp(what, "restore") == 0) {
    check(self, api->restore_state(self, id, &clock));
    out[0] = clock_as_struct(&clock);
  } else {
    check(self, api->release_state(self, id));
  }
}

/* The .m files of this package see to the number of the arguments. */
void mexFunction(int wanted, mxArray* out[], int count, const mxArray* in[]) {
  char what[16] = "";
  void* self;
  int k;
  if (count < 2 || mxGetString(in[0], what, sizeof what) != 0)
    mexErrMsgTxt("__tandem__ is for the package's own use");
  if (strcmp(what, "serve") == 0) {
    serve(out, count - 1, in + 1);
    return;
  }
  if (strcmp(what, "connect") == 0) {
    connect_to(out, in + 1);
    return;
  }
  k = index_of(in[1]);
  self = handles[k];
  if (strcmp(what, "close") == 0) {
    handles[k] = NULL;
    tandem_remote()->destroy(self);
  } else if (strcmp(what, "info") == 0) {
    out[0] = info_as_struct(tandem_remote()->info(self));
  } else if (strcmp(what, "initialize") == 0) {
    start(self, wanted, out, in + 2);
  } else if (strcmp(what, "advance") == 0) {
    go_on(self, wanted, out, in + 2);
  } else {
    use_state(self, what, out, in + 2);
  }
}
