/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* What the functions of this package stand on, a MEX file over tandem/peer.h:
 *   status = __tandem__ ("serve", make, parameters, ARGUMENTS)
 *   handle = __tandem__ ("connect", uri, allow_plaintext)
 *   ... = __tandem__ ("info" | "initialize" | "advance" | "sample" | "save" | "restore" | "release" |
 * "close", handle,
 * ...) */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "octave_peer.h"

enum { MAX_HANDLES = 64, ROOM = 1000 };

/* A subsystem elsewhere, driven from Octave. */
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

static void give_sample(void* self, mxArray** out, const mxArray** in) {
  const tandem_info* const i = tandem_remote()->info(self);
  const int32_t parts = (int32_t)mxGetScalar(in[2]);
  const int64_t outputs = tandem_row_size(i) - 2; /* held ones have no derivatives */
  tandem_clock clock;
  if (!mxIsDouble(in[1]) || (int64_t)mxGetNumberOfElements(in[1]) != scalars(i))
    mexErrMsgIdAndTxt("tandem:invalid_argument", "u has %d numbers; allowed are %d",
                      (int)mxGetNumberOfElements(in[1]), (int)scalars(i));
  out[1] = mxCreateDoubleMatrix(1, parts & TANDEM_SAMPLE_OUTPUTS ? (mwSize)outputs : 0, mxREAL);
  check(self,
        tandem_remote()->sample(self, mxGetScalar(in[0]), parts, mxGetPr(in[1]), mxGetPr(out[1]), &clock));
  out[0] = clock_as_struct(&clock);
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
    serve_model(out, count - 1, in + 1);
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
    out[0] = info_as_struct(tandem_remote(), self);
  } else if (strcmp(what, "initialize") == 0) {
    start(self, wanted, out, in + 2);
  } else if (strcmp(what, "advance") == 0) {
    go_on(self, wanted, out, in + 2);
  } else if (strcmp(what, "sample") == 0) {
    give_sample(self, out, in + 2);
  } else {
    use_state(self, what, out, in + 2);
  }
}
