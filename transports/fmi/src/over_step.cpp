// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "over_step.hpp"

#include <algorithm>
#include <cmath>

namespace tandem::fmi {
namespace {

double polynomial(const Segment& piece, double t) {
  const double x = t - piece.origin;
  double v = 0.0;
  for (int k = TANDEM_MAX_COEFFICIENTS - 1; k >= 0; --k) v = v * x + piece.c[k];
  return v;
}

/// Exact to degree 5 (C. F. Gauss, Methodus nova integralium valores per approximationem inveniendi, 1815).
double integral(const Segment& piece, double from, double to) {
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from), point = half * std::sqrt(0.6);
  return half / 9.0 *
         (8.0 * polynomial(piece, middle) +
          5.0 * (polynomial(piece, middle - point) + polynomial(piece, middle + point)));
}

}  // namespace

/// A piece that ends at the step's begin, but for rounding, is none of it; so it does not matter where a call
/// begins.
double mean_over(const Signal& signal, const OwnStep& s) {
  const TimeTolerance tolerance(s.begin);
  const auto pieces = signal.segments();
  double sum = 0.0, from = s.begin;
  for (std::size_t k = 0; k < pieces.size() && from < s.end; ++k) {
    const bool last = k + 1 == pieces.size() || !tolerance.before(pieces[k].end, s.end);
    const double to = last ? s.end : pieces[k].end;
    if (!last && !tolerance.before(from, to)) continue;
    if (signal.degree() == 0 && last && from == s.begin) return pieces[k].c[0];  // to the last digit
    sum += integral(pieces[k], from, to);
    from = to;
  }
  return sum / (s.end - s.begin);
}

Signal from_begin(const Signal& signal, const OwnStep& s) {
  const TimeTolerance tolerance(s.begin);
  const auto pieces = signal.segments();
  std::size_t k = 0;
  while (k + 1 < pieces.size() && !tolerance.before(s.begin, pieces[k].end)) ++k;
  return {&pieces[k], static_cast<std::int32_t>(pieces.size() - k), signal.degree()};
}

}  // namespace tandem::fmi
