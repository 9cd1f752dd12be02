// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cassert>
#include <cstdint>
#include <span>

#include "tandem/reaction.h"
#include "tandem/time_grid.hpp"

namespace tandem {

/// One polynomial piece, sum over k of c[k] (t - origin)^k for t <= end. See signal.h; the layout is the
/// same.
using Segment = tandem_segment;

/// Marks a segment, or takes its mark away: the input jumps at its begin, which is its origin, or does not
/// (tandem_segment_jumps). Precondition: degree below 5.
inline void mark_jump(Segment& s, bool jumps) { s.c[TANDEM_MAX_COEFFICIENTS - 1] = jumps ? -0.0 : 0.0; }

/// Adds the coefficients of p about another origin, p(t) = sum c_k (t - to)^k, to `c`: a Taylor shift.
inline void add_shifted(const Segment& p, double to, double* c) {
  double d[TANDEM_MAX_COEFFICIENTS];
  std::copy(p.c, p.c + TANDEM_MAX_COEFFICIENTS, d);
  const double x = to - p.origin;
  for (int k = 0; k < TANDEM_MAX_COEFFICIENTS - 1; ++k)
    for (int i = TANDEM_MAX_COEFFICIENTS - 2; i >= k; --i) d[i] += x * d[i + 1];
  for (int k = 0; k < TANDEM_MAX_COEFFICIENTS; ++k) c[k] += d[k];
}

/// One scalar input as a function of time over the span of one call: a piecewise polynomial of up to six
/// coefficients a piece. A view: the segments belong to the caller of Subsystem::advance and live until that
/// call returns.
class Signal {
 public:
  Signal() = default;
  /// Segments with ascending ends, at least one; coefficients above degree are zero (0 <= degree <= 5).
  Signal(const Segment* segments, std::int32_t count, std::int32_t degree)
      : data_{segments, count, degree, nullptr} {
    assert(count >= 1 && degree >= 0 && degree < TANDEM_MAX_COEFFICIENTS);
  }

  /// Value at t [s], in the unit of the port. A break belongs to the segment before it; the last segment goes
  /// on for ever.
  double value(double t) const { return tandem_signal_value(&data_, t); }

  /// Time derivative at t [s], per second.
  double derivative(double t) const { return tandem_signal_derivative(&data_, t); }

  /// Second time derivative at t [s], per second squared.
  double second_derivative(double t) const { return tandem_signal_second_derivative(&data_, t); }

  /// The first time after `t` [s] at which it is known to jump; infinite if there is none.
  double next_jump(double t) const { return tandem_signal_next_jump(&data_, t); }
  /// Whether it has jumped at `t`, at which a call begins.
  bool jumps_at(double t, const TimeTolerance& tolerance) const {
    return tandem_segment_jumps(data_.segments) && !tolerance.before(data_.segments->origin, t);
  }
  /// From its jump at `t` on, whose value there is the one after; the whole signal if it has none there.
  Signal from_jump_at(double t) const {
    const tandem_signal from = tandem_signal_from_jump(&data_, t);
    return Signal(from.segments, from.count, from.degree).with(from.reactive);
  }

  std::span<const Segment> segments() const {
    return {data_.segments, static_cast<std::size_t>(data_.count)};
  }
  std::int32_t degree() const { return data_.degree; }

  /// What it has besides, as an answer to the subsystem's outputs; null: nothing. What value() and its like give is
  /// without it.
  const tandem_reactive_input* reactive() const { return data_.reactive; }
  /// The same with such an answer, which outlives it.
  Signal with(const tandem_reactive_input* reactive) const {
    Signal other = *this;
    other.data_.reactive = reactive;
    return other;
  }
  /// Value at t [s], the answer included; z: the states of the reaction.
  double value(double t, const double* z) const { return tandem_reactive_value(&data_, t, z); }

 private:
  tandem_signal data_{nullptr, 0, 0, nullptr};
};
static_assert(sizeof(Signal) == sizeof(tandem_signal), "a Signal crosses the C interface without a copy");

/// By which some inputs answer the subsystem's outputs (reaction.h).
using Reaction = tandem_reaction;
/// That of a call; null: none of its inputs does.
inline const Reaction* reaction_of(std::span<const Signal> u) {
  for (const Signal& one : u)
    if (one.reactive()) return one.reactive()->reaction;
  return nullptr;
}

}  // namespace tandem
