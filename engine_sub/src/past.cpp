// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "past.hpp"

#include <algorithm>
#include <limits>

namespace tandem::engine {

void Past::clear() { memory_[1] = 0.0, memory_[2] = memory_[3] = -1.0; }

void Past::record(double t, double u, int level) {
  const long now = total();
  const double there = now > 0 && this->t(now - 1) == t ? point(now - 1)[2] : -1.0;
  if (there >= 0.0 && level == 0) return;
  if (there > 0.0) {  // another event of the same instant
    point(now - 1)[1] = u, point(now - 1)[2] = std::min<double>(there, level);
    return;
  }
  if (level > 0 && first() >= 0 && last() < 0) memory_[3] = static_cast<double>(now - 1);
  point(now)[0] = t, point(now)[1] = u, point(now)[2] = level;
  memory_[1] = static_cast<double>(now + 1);
}

double Past::due() const {
  if (first() < 0) return t(0) + delay_.time;
  return last() < 0 ? std::numeric_limits<double>::infinity() : t(last()) + delay_.time;
}

int Past::turn() {
  const long begin = first() < 0 ? 0 : last() + 1;
  long end = begin + 1;
  while (end < total() && point(end)[2] == 0.0) ++end;
  memory_[2] = static_cast<double>(begin);
  memory_[3] = end < total() ? static_cast<double>(end - 1) : -1.0;
  return static_cast<int>(point(begin)[2]);
}

/// The last of the points low .. high - 1 that is not after t, or low.
long Past::interval(long low, long high, double at) const {
  while (high - low > 1) {
    const long middle = low + (high - low) / 2;
    (t(middle) <= at ? low : high) = middle;
  }
  return low;
}

/// Lagrange's form.
double Past::value(double at) const {
  if (first() < 0) return initial();
  const long end = last() < 0 ? total() - 1 : last();
  const long begin = std::max(first(), total() - delay_.points);
  const long k = interval(begin, end, at);
  const long right = std::min(end, std::max(k, begin + 1) + 2), left = std::max(begin, right - 3);
  double sum = 0.0;
  for (long i = left; i <= right; ++i) {
    double weight = 1.0;
    for (long j = left; j <= right; ++j)
      if (j != i) weight *= (at - t(j)) / (t(i) - t(j));
    sum += weight * u(i);
  }
  return sum;
}

}  // namespace tandem::engine
