// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>

#include "tandem/fixed_step.hpp"

namespace tandem::test {

/// Calls take(segment, from, to) for each piece of the signal that the step crosses, in order; together they
/// cover it.
template <class Take>
void for_each_piece(const Signal& u, const OwnStep& step, const Take& take) {
  double from = step.begin;
  for (const Segment& piece : u.segments()) {
    const bool last = &piece == &u.segments().back();
    const double to = last ? step.end : std::min(piece.end, step.end);
    if (to <= from) continue;
    take(piece, from, to);
    from = to;
  }
}

/// Coefficients of the piece's polynomial in powers of t - origin (Taylor shift by repeated synthetic
/// division).
inline std::array<double, TANDEM_MAX_COEFFICIENTS> shifted(const Segment& piece, double origin) {
  std::array<double, TANDEM_MAX_COEFFICIENTS> c{};
  std::copy(piece.c, piece.c + c.size(), c.begin());
  for (std::size_t k = 0; k + 1 < c.size(); ++k)
    for (std::size_t i = c.size() - 1; i-- > k;) c[i] += (origin - piece.origin) * c[i + 1];
  return c;
}

}  // namespace tandem::test
