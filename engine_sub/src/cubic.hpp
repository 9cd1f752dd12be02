// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tandem::engine {

/// The slope at a point between lines of slopes a and b over lengths h and k: Brodlie's weighted harmonic
/// mean (F. Fritsch, J. Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300).
inline double harmonic(double a, double h, double b, double k) {
  if (a * b <= 0.0) return 0.0;
  const double weight = (h + 2.0 * k) / (3.0 * (h + k));
  return a * b / (weight * b + (1.0 - weight) * a);
}

/// A value and a slope at each end of a line of length h.
struct Ends {
  double h, y0, slope0, y1, slope1;
};

/// Hermite's cubic at the part s of the line.
inline double hermite(const Ends& e, double s) {
  const double r = 1.0 - s;
  return r * r * ((1.0 + 2.0 * s) * e.y0 + s * e.h * e.slope0) +
         s * s * ((1.0 + 2.0 * r) * e.y1 - r * e.h * e.slope1);
}

}  // namespace tandem::engine
