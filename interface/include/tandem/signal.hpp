// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cassert>
#include <cstdint>
#include <span>

#include "tandem/subsystem.h"

namespace tandem {

/// One polynomial piece, sum over k of c[k] (t - origin)^k for t <= end. See subsystem.h; the layout is the
/// same.
using Segment = tandem_segment;

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

  /// Value at t, in the unit of the port. A break belongs to the segment before it; the last segment goes on
  /// for ever.
  double value(double t) const {
    const Segment& s = at(t);
    const double x = t - s.origin, x2 = x * x;  // Estrin's scheme: no loop, and half the latency of Horner's
    return (s.c[0] + s.c[1] * x) + x2 * ((s.c[2] + s.c[3] * x) + x2 * (s.c[4] + s.c[5] * x));
  }

  /// Time derivative at t, per second.
  double derivative(double t) const {
    const Segment& s = at(t);
    const double x = t - s.origin;
    double v = 0.0;
    for (std::int32_t k = data_.degree; k > 0; --k) v = v * x + k * s.c[k];
    return v;
  }

  std::span<const Segment> segments() const {
    return {data_.segments, static_cast<std::size_t>(data_.count)};
  }
  std::int32_t degree() const { return data_.degree; }

 private:
  const Segment& at(double t) const {
    const Segment* s = data_.segments;
    if (data_.count == 1 || t <= s->end) return *s;
    const Segment* last = s + (data_.count - 1);
    return t > last[-1].end ? *last : search(t);
  }
  /// First segment whose end is at or past t, by bisection. Precondition: it is neither the first nor the
  /// last.
  const Segment& search(double t) const {
    const Segment* first = data_.segments;
    std::int32_t left = 1, right = data_.count - 2;
    while (left < right) {
      const std::int32_t middle = left + (right - left) / 2;
      if (t <= first[middle].end)
        right = middle;
      else
        left = middle + 1;
    }
    return first[left];
  }

  tandem_signal data_{nullptr, 0, 0, nullptr};
};
static_assert(sizeof(Signal) == sizeof(tandem_signal), "a Signal crosses the C interface without a copy");

}  // namespace tandem
