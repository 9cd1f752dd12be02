/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* An input as a function of time, in C99: a piecewise polynomial, sent as data. */
#ifndef TANDEM_SIGNAL_H
#define TANDEM_SIGNAL_H
#include <math.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define TANDEM_MAX_COEFFICIENTS 6

struct tandem_reactive_input; /* tandem/reaction.h */

/* One polynomial piece of an input: it holds for t <= end (the tolerance for rounding is already added to
 * end), and its value is sum over k of c[k] * (t - origin)^k. */
typedef struct tandem_segment {
  double end;
  double origin;
  double c[TANDEM_MAX_COEFFICIENTS];
} tandem_segment;

/* Whether the input jumps at the begin of this piece, its `origin`: by a held output's new value, or by a row
 * marked as a jump. The mark is the minus of the last coefficient, -0.0, which changes no value. A piece that
 * only carries the mark ends where the one before it does. Where a call begins with a marked piece whose
 * origin is the time of the call, the input has jumped there since the call before. */
static inline int tandem_segment_jumps(const tandem_segment* s) {
  const double last = s->c[TANDEM_MAX_COEFFICIENTS - 1];
  return last == 0.0 && signbit(last);
}

/* One input over the span of one `advance`: `count` >= 1 segments, ends ascending. The last one goes on
 * beyond its end. Coefficients above `degree` are zero. A break belongs to the segment before it. `reactive`
 * is NULL but for a subsystem with TANDEM_REACTIVE_INPUTS: what the input has besides, as an answer to the
 * subsystem's own outputs (tandem/reaction.h). */
typedef struct tandem_signal {
  const tandem_segment* segments;
  int32_t count;
  int32_t degree;
  const struct tandem_reactive_input* reactive;
} tandem_signal;

/* The piece that holds at t [s]: the first whose end is at or past t, else the last. */
static inline const tandem_segment* tandem_signal_at(const tandem_signal* u, double t) {
  const tandem_segment* const s = u->segments;
  int32_t left = 1, right = u->count - 2;
  if (u->count == 1 || t <= s->end) return s;
  if (t > s[right].end) return s + right + 1;
  while (left < right) {
    const int32_t middle = left + (right - left) / 2;
    if (t <= s[middle].end)
      right = middle;
    else
      left = middle + 1;
  }
  return s + left;
}

/* Value at t [s], in the unit of the port. Whoever evaluates a signal in another language gets the same bits
 * in this order of operations, without fused multiply-adds (Estrin's scheme: no loop, and half the latency of
 * Horner's). */
static inline double tandem_signal_value(const tandem_signal* u, double t) {
  const tandem_segment* const s = tandem_signal_at(u, t);
  const double x = t - s->origin, x2 = x * x;
  return (s->c[0] + s->c[1] * x) + x2 * ((s->c[2] + s->c[3] * x) + x2 * (s->c[4] + s->c[5] * x));
}

/* Time derivative at t [s], per second. */
static inline double tandem_signal_derivative(const tandem_signal* u, double t) {
  const tandem_segment* const s = tandem_signal_at(u, t);
  const double x = t - s->origin;
  double v = 0.0;
  int32_t k = u->degree;
  for (; k > 0; --k) v = v * x + k * s->c[k];
  return v;
}

/* Second time derivative at t [s], per second squared. */
static inline double tandem_signal_second_derivative(const tandem_signal* u, double t) {
  const tandem_segment* const s = tandem_signal_at(u, t);
  const double x = t - s->origin;
  double v = 0.0;
  int32_t k = u->degree;
  for (; k > 1; --k) v = v * x + k * (k - 1) * s->c[k];
  return v;
}

/* The first time after t [s] at which it is known to jump; infinite if there is none. */
static inline double tandem_signal_next_jump(const tandem_signal* u, double t) {
  int32_t k;
  for (k = 0; k < u->count; ++k)
    if (tandem_segment_jumps(u->segments + k) && u->segments[k].origin > t) return u->segments[k].origin;
  return INFINITY;
}

/* From its jump at t on, the last of them, whose value there is the one after; the whole signal if it has
 * none there. */
static inline tandem_signal tandem_signal_from_jump(const tandem_signal* u, double t) {
  tandem_signal from = *u;
  int32_t k;
  for (k = u->count - 1; k >= 0; --k)
    if (tandem_segment_jumps(u->segments + k) && u->segments[k].origin == t) {
      from.segments += k;
      from.count -= k;
      return from;
    }
  return from;
}

#ifdef __cplusplus
}
#endif
#endif
