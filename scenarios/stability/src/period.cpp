// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "period.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "tandem/stability/super_step.hpp"

namespace tandem::stability {
namespace {

/// Of n of the largest. rounding: of a quotient of two lengths, as a part of it.
Period period_of(std::int64_t n, double largest, const std::vector<double>& lengths, double rounding) {
  Period period;
  period.length = std::numeric_limits<double>::infinity();
  for (const double h : lengths) {
    const double ratio = static_cast<double>(n) * largest / h, steps = std::round(ratio);
    period.steps.push_back(static_cast<std::int64_t>(steps));
    period.length = std::min(period.length, steps * h), period.last = std::max(period.last, steps * h);
    if (const double apart = std::abs(ratio - steps); apart > rounding * steps)
      period.apart = std::max(period.apart, apart);
  }
  return period;
}

}  // namespace

Period common_period(const std::vector<double>& lengths, double start) {
  constexpr double near = 1e-3, of_products = 1e-12;  // steps are quotients and products of few numbers
  const auto [least, most_of_all] = std::minmax_element(lengths.begin(), lengths.end());
  const double smallest = *least, largest = *most_of_all, ratio = largest / smallest;
  const double rounding =
      of_products + 8.0 * std::numeric_limits<double>::epsilon() * std::abs(start) / smallest;
  const auto most =
      std::clamp(static_cast<std::int64_t>(most_steps_of_all / ratio), std::int64_t{1}, most_steps);
  std::optional<Period> nearly, best;
  for (std::int64_t n = 1; n <= most; ++n) {
    Period period = period_of(n, largest, lengths, rounding);
    if (period.apart == 0.0) return period;
    if (!nearly && period.apart <= near) nearly = period;
    if (!best || period.apart < best->apart) best = std::move(period);
  }
  return nearly ? *nearly : *best;
}

}  // namespace tandem::stability
