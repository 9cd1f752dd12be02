// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "instants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "refuse.hpp"

namespace tandem::engine {
namespace {

constexpr double rounding = 1e-9;    // of a period, in a common measure
constexpr double coincides = 1e-12;  // of a period
constexpr double most_ratio = 1e6;   // of a period to a common measure

/// The largest time of which both periods are multiples (Euclid's algorithm); 0 if there is none.
double common_measure(double a, double b) {
  const double least = rounding * std::min(a, b);
  const double smallest = std::min(a, b) / most_ratio;
  while (b > least) {
    const double rest = std::fmod(a, b);
    a = std::exchange(b, b - rest < least ? 0.0 : rest);
    if (a < smallest) return 0.0;
  }
  return a;
}

/// Instants of the two differ by multiples of their common measure, beside the difference of the offsets.
double shortest_between(const Periodic& a, const Periodic& b, const Program& program) {
  const double measure = common_measure(a.period, b.period);
  if (measure == 0.0)
    refuse("", fmt::format("{} samples every {} s and {} every {} s, which have no common measure, in a "
                           "diagram that is sampled wholly; allowed is a ratio of whole numbers up to {}",
                           program.named(a.name), a.period, program.named(b.name), b.period, most_ratio));
  const double rest = std::abs(std::remainder(a.offset - b.offset, measure));
  return rest <= coincides * std::min(a.period, b.period) ? measure : rest;
}

}  // namespace

double shortest_period(const Program& program) {
  const auto& all = program.periodics;
  double shortest = all.front().period;
  for (std::size_t k = 0; k < all.size(); ++k) {
    shortest = std::min(shortest, all[k].period);
    for (std::size_t other = 0; other < k; ++other)
      shortest = std::min(shortest, shortest_between(all[k], all[other], program));
  }
  return shortest;
}

}  // namespace tandem::engine
