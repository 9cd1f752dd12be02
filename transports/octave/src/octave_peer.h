/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* The parts of the MEX file. */
#ifndef TANDEM_OCTAVE_PEER_H
#define TANDEM_OCTAVE_PEER_H
#include <mex.h>

#include "tandem/peer.h"

/* A model in Octave as a subsystem, what __tandem_model__.m makes of the struct of the user's that `make`
 * gives; parameters: what __tandem_declared__.m gives. Valid during the call of the MEX file. */
const tandem_subsystem_api* octave_model(mxArray* make, mxArray* parameters);

/* What such a struct says of itself, without its texts, which are Octave's; 0 if there is no memory. */
int read_info(const mxArray* user, tandem_info* info);
void free_info(tandem_info* info);
/* The usual magnitudes of its outputs, for free(); NULL if there is no memory. */
double* nominal_of(const mxArray* user);
/* The rows of __tandem_declared__.m, in memory that is Octave's. */
tandem_parameter* parameters_in(const mxArray* cells);
/* As tandem_info.m gives it. */
mxArray* info_as_struct(const tandem_subsystem_api* api, void* self);

/* Inputs as tandem_signal.m makes them, a struct array with an element for each, NULL if they have more
 * segments: Octave copies them for each step. And its element k. */
enum { MAX_SEGMENTS = 131072 };
mxArray* inputs_as_array(const tandem_signal* u, size_t count);
/* The same of inputs that are constant, about t. */
mxArray* constants_as_array(const double* u, size_t count, double t);
tandem_signal signal_of(const mxArray* u, mwIndex k);

/* status = __tandem__ ("serve", make, parameters, ARGUMENTS), from `make` on. */
void serve_model(mxArray** out, int count, const mxArray** in);

#endif
