// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/stability/largest_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tandem/scenario/steps.hpp"
#include "tandem/stability/modes.hpp"

namespace tandem::stability {
namespace {

using scenario::Scenario;

bool is_stable(Scenario scenario, const Builtins& builtins, double rate, double factor) {
  scenario::scale_steps(scenario, builtins, factor);
  const SuperStep step = super_step(scenario, builtins);
  return is_stable(step, spectral_radius(step.map), rate);
}

double largest_factor_of(const Scenario& scenario, const Builtins& builtins, double rate, bool linear) {
  constexpr double scan = 1.1, precision = 1e-6;
  double good = smallest_factor(linear);
  if (!is_stable(scenario, builtins, rate, good)) return 0.0;
  double bad = good * scan;
  for (; is_stable(scenario, builtins, rate, bad); bad *= scan) {
    if (bad > largest_factor) return std::numeric_limits<double>::infinity();
    good = bad;
  }
  while (bad > good * (1.0 + precision)) {
    const double middle = std::sqrt(good * bad);
    (is_stable(scenario, builtins, rate, middle) ? good : bad) = middle;
  }
  return good;
}

/// The first of an order that is given, or the one with the longest own step, or the shortest where that leads.
std::size_t leader(const Scenario& scenario, const SuperStep& step) {
  const bool slowest = scenario.coordination.schedule != Schedule::Kind::fastest_first;
  if (const auto& order = scenario.coordination.order; !order.empty()) {
    const auto& all = scenario.subsystems;
    const auto it = std::find_if(all.begin(), all.end(), [&](const auto& one) {
      return one.name == (slowest ? order.front() : order.back());
    });
    return static_cast<std::size_t>(it - all.begin());
  }
  const auto& steps = step.steps;
  return static_cast<std::size_t>((slowest ? std::min_element(steps.begin(), steps.end())
                                           : std::max_element(steps.begin(), steps.end())) -
                                  steps.begin());
}

}  // namespace

LargestStep largest_step(const Scenario& scenario, const Builtins& builtins) {
  const Stability here = stability(scenario, builtins);
  const SuperStep& step = here.step;
  const double factor = largest_factor_of(scenario, builtins, here.rate, step.linear);
  const auto length = [&](std::size_t i) { return step.period / static_cast<double>(step.steps[i]); };
  if (scenario.coordination.schedule == Schedule::Kind::parallel) {
    double largest = 0.0;
    for (std::size_t i = 0; i < step.steps.size(); ++i) largest = std::max(largest, length(i));
    return {step.linear, factor, "communication step",
            scenario.coordination.communication_step.value_or(largest)};
  }
  const std::size_t first = leader(scenario, step);
  return {step.linear, factor, scenario.subsystems[first].name, length(first)};
}

}  // namespace tandem::stability
