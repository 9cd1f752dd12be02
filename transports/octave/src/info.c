/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* What a subsystem says of itself, from Octave and to it. */
#include <math.h>
#include <stdlib.h>

#include "octave_peer.h"

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

double* nominal_of(const mxArray* user) {
  const mxArray* const cells = mxGetField(user, 0, "outputs");
  const size_t rows = mxGetM(cells);
  double* const all = calloc(rows + 1, sizeof *all);
  size_t k;
  for (k = 0; all && k < rows; ++k) all[k] = mxGetScalar(mxGetCell(cells, k + 3 * rows));
  return all;
}

int read_info(const mxArray* user, tandem_info* info) {
  const mxArray* const pairs = mxGetField(user, 0, "feedthrough");
  const size_t count = mxGetM(pairs);
  tandem_feedthrough* const f = calloc(count + 1, sizeof *f);
  size_t k;
  for (k = 0; f && k < count; ++k) {
    f[k].output = (int32_t)mxGetPr(pairs)[k] - 1;
    f[k].input = (int32_t)mxGetPr(pairs)[k + count] - 1;
  }
  info->name = mxArrayToString(mxGetField(user, 0, "name"));
  info->abilities = TANDEM_SAVES_STATE | TANDEM_RESTARTS;
  info->abilities |= mxGetScalar(mxGetField(user, 0, "sampled")) != 0.0 ? TANDEM_SAMPLED : TANDEM_LANDS;
  info->inputs = ports_of(mxGetField(user, 0, "inputs"), &info->input_count, 1);
  info->outputs = ports_of(mxGetField(user, 0, "outputs"), &info->output_count, 0);
  info->feedthrough = f;
  info->feedthrough_count = (int32_t)count;
  return info->name && info->inputs && info->outputs && f;
}

/* NULL of an empty array. */
static const char* text_in(const mxArray* cells, size_t row, size_t column) {
  const mxArray* const cell = mxGetCell(cells, row + column * mxGetM(cells));
  return mxIsChar(cell) ? mxArrayToString(cell) : NULL;
}

tandem_parameter* parameters_in(const mxArray* cells) {
  const size_t count = mxGetM(cells);
  tandem_parameter* const all = mxCalloc(count + 1, sizeof *all);
  size_t k;
  for (k = 0; k < count; ++k) {
    all[k].name = text_in(cells, k, 0);
    all[k].unit = text_in(cells, k, 1);
    all[k].otherwise = text_in(cells, k, 2);
    all[k].sentence = text_in(cells, k, 3);
  }
  return all;
}

void free_info(tandem_info* info) {
  free((void*)info->inputs);
  free((void*)info->outputs);
  free((void*)info->feedthrough);
}

/* held: a flag for each; NULL: none is. */
static mxArray* array_of_ports(const tandem_port* ports, int32_t count, const int32_t* held) {
  static const char* names[] = {"name", "unit", "size", "derivatives", "start", "held"};
  mxArray* const all = mxCreateStructMatrix(1, (mwSize)count, 6, names);
  mwIndex k;
  for (k = 0; k < (mwIndex)count; ++k) {
    mxSetField(all, k, "name", mxCreateString(ports[k].name));
    mxSetField(all, k, "unit", mxCreateString(ports[k].unit));
    mxSetField(all, k, "size", mxCreateDoubleScalar(ports[k].size));
    mxSetField(all, k, "derivatives", mxCreateDoubleScalar(ports[k].derivatives));
    mxSetField(all, k, "start", mxCreateDoubleScalar(ports[k].start));
    mxSetField(all, k, "held", mxCreateLogicalScalar(held && held[k]));
  }
  return all;
}

mxArray* info_as_struct(const tandem_subsystem_api* api, void* self) {
  static const char* names[] = {"name", "inputs", "outputs", "feedthrough", "abilities", "period", "latency"};
  const tandem_info* const i = api->info(self);
  mxArray* const all = mxCreateStructMatrix(1, 1, 7, names);
  mxArray* const pairs = mxCreateDoubleMatrix((mwSize)i->feedthrough_count, 2, mxREAL);
  double period = 0.0, latency = 0.0;
  int32_t k;
  api->sampling(self, &period, &latency);
  for (k = 0; k < i->feedthrough_count; ++k) {
    mxGetPr(pairs)[k] = i->feedthrough[k].output + 1;
    mxGetPr(pairs)[k + i->feedthrough_count] = i->feedthrough[k].input + 1;
  }
  mxSetField(all, 0, "name", mxCreateString(i->name));
  mxSetField(all, 0, "inputs", array_of_ports(i->inputs, i->input_count, NULL));
  mxSetField(all, 0, "outputs", array_of_ports(i->outputs, i->output_count, api->held(self)));
  mxSetField(all, 0, "feedthrough", pairs);
  mxSetField(all, 0, "abilities", mxCreateDoubleScalar(i->abilities));
  mxSetField(all, 0, "period", mxCreateDoubleScalar(period));
  mxSetField(all, 0, "latency", mxCreateDoubleScalar(latency));
  return all;
}
