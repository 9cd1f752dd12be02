/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
#include "octave_peer.h"

static size_t segments_of(const tandem_signal* u, size_t count) {
  size_t i, all = 0;
  for (i = 0; i < count; ++i) all += (size_t)u[i].count;
  return all;
}

mxArray* inputs_as_array(const tandem_signal* u, size_t count) {
  static const char* names[] = {"end", "origin", "c"};
  mxArray* all;
  size_t i, j, k;
  if (segments_of(u, count) > MAX_SEGMENTS) return NULL;
  all = mxCreateStructMatrix(1, count, 3, names);
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

mxArray* constants_as_array(const double* u, size_t count, double t) {
  tandem_segment* const segments = mxCalloc(count + 1, sizeof *segments);
  tandem_signal* const signals = mxCalloc(count + 1, sizeof *signals);
  mxArray* all;
  size_t i;
  for (i = 0; i < count; ++i) {
    segments[i].end = segments[i].origin = t;
    segments[i].c[0] = u[i];
    signals[i].segments = segments + i;
    signals[i].count = 1;
  }
  all = inputs_as_array(signals, count);
  mxFree(segments);
  mxFree(signals);
  return all;
}

tandem_signal signal_of(const mxArray* u, mwIndex k) {
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
