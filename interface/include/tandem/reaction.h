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

/* (factor + rate s) w is a part of the derivative of state `to`: w is state `from`, or, from `states` on, the
 * subsystem's scalar output number from - states, at the same time and with the inputs that follow from it. */
typedef struct tandem_reaction_term {
  int32_t to, from;
  double factor, rate;
} tandem_reaction_term;

/* c[0] + c[1] s + c[2] s^2 + c[3] s^3 is a part of the derivative of state `to`. */
typedef struct tandem_reaction_course {
  int32_t to, reserved;
  double c[4];
} tandem_reaction_course;

/* Linear differential equations of the states z, with s = t - origin. Events do not change z. Each row of samples
 * ends with z at its time, behind the derivatives: its stride is exactly so much longer. */
typedef struct tandem_reaction {
  int32_t states; /* at most six for each scalar input, or output, whichever are fewer */
  int32_t terms, courses;
  double origin; /* [s] */
  const tandem_reaction_term* term;
  const tandem_reaction_course* course;
  const double* begin; /* z at the begin of the call */
} tandem_reaction;

/* What an input has beside its polynomial: gain times a state. All inputs that have it go by the same reaction.
 * Derivatives of a signal are without it. */
typedef struct tandem_reactive_input {
  const tandem_reaction* reaction;
  int32_t state;
  double gain;
} tandem_reactive_input;

/* dz/dt at t [s]. y: all scalar outputs of the subsystem. */
static inline void tandem_reaction_rates(const tandem_reaction* r, double t, const double* z, const double* y,
                                         double* rates) {
  const double s = t - r->origin;
  const tandem_reaction_term *term = r->term, *end = term + r->terms;
  int32_t k;
  for (k = 0; k < r->states; ++k) rates[k] = 0.0;
  for (k = 0; k < r->courses; ++k) {
    const double* const c = r->course[k].c;
    rates[r->course[k].to] += (c[0] + c[1] * s) + s * s * (c[2] + c[3] * s);
  }
  for (; term < end; ++term)
    rates[term->to] += (term->factor + term->rate * s) *
                       (term->from < r->states ? z[term->from] : y[term->from - r->states]);
}

/* The value of an input at t [s] with these states; z may be NULL where it does not react. */
static inline double tandem_reactive_value(const tandem_signal* u, double t, const double* z) {
  const double value = tandem_signal_value(u, t);
  return u->reactive ? value + u->reactive->gain * z[u->reactive->state] : value;
}

#ifdef __cplusplus
}
#endif
#endif
