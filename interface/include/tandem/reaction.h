/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* Inputs that answer the subsystem's own outputs within a call, in C99. They follow from a few states that the
 * subsystem integrates along with its own, by its own method and at all its stages, so that nothing is exchanged
 * meanwhile. A subsystem with TANDEM_REACTIVE_INPUTS can do that. It keeps nothing of it between calls. */
#ifndef TANDEM_REACTION_H
#define TANDEM_REACTION_H
#include "tandem/signal.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The states z go by
 *
 *   z' = A z + (B0 + B1 s) y + c0 + c1 s + c2 s^2 + c3 s^3,   s = t - origin
 *
 * with some of the subsystem's outputs y at the same time, none of which follows at once from an input without
 * reaction that is not known. Events do not change them.
 *
 * Each row of samples ends with z at its time, behind the derivatives: its stride is so much longer. */
typedef struct tandem_reaction {
  int32_t states;        /* n, at most six for each scalar input, or output, whichever are fewer */
  int32_t outputs;       /* p */
  const int32_t* output; /* p scalar outputs, y */
  double origin;         /* [s] */
  const double* a;       /* A, n x n by rows [1/s] */
  const double* b0;      /* n x p */
  const double* b1;      /* n x p */
  const double* c;       /* n x 4 */
  const double* begin;   /* z at the begin of the call */
} tandem_reaction;

/* What an input has beside its polynomial: row . z. All inputs that have it go by the same reaction. */
typedef struct tandem_reactive_input {
  const tandem_reaction* reaction;
  const double* row; /* n */
} tandem_reactive_input;

/* z' at t [s]. y: all scalar outputs of the subsystem. */
static inline void tandem_reaction_rates(const tandem_reaction* r, double t, const double* z, const double* y,
                                         double* rates) {
  const double s = t - r->origin;
  const double *a = r->a, *b0 = r->b0, *b1 = r->b1, *c = r->c;
  int32_t i, k;
  for (i = 0; i < r->states; ++i, c += 4) {
    double sum = (c[0] + c[1] * s) + s * s * (c[2] + c[3] * s);
    for (k = 0; k < r->outputs; ++k) sum += (*b0++ + s * *b1++) * y[r->output[k]];
    for (k = 0; k < r->states; ++k) sum += *a++ * z[k];
    rates[i] = sum;
  }
}

/* The value of an input at t [s] with these states; z may be NULL where it does not react. */
static inline double tandem_reactive_value(const tandem_signal* u, double t, const double* z) {
  double value = tandem_signal_value(u, t);
  if (u->reactive) {
    const double* row = u->reactive->row;
    int32_t k;
    for (k = 0; k < u->reactive->reaction->states; ++k) value += row[k] * z[k];
  }
  return value;
}

#ifdef __cplusplus
}
#endif
#endif
