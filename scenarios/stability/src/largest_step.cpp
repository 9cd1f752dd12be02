// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/stability/largest_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "tandem/error.hpp"
#include "tandem/scenario/steps.hpp"
#include "tandem/stability/modes.hpp"

namespace tandem::stability {
namespace {

using scenario::Scenario;

double smallest_factor(const Stability& here) {
  const SuperStep& step = here.step;
  if (step.linear && std::ranges::find(step.sampled, true) == step.sampled.end()) return 1e-3;
  return is_stable(step, here.radius, here.rate) ? 1.0 : 1.0 / 16.0;
}

/// A scan, then bisection.
class Search {
 public:
  Search(const Scenario& scenario, const Builtins& builtins, const Stability& here)
      : scenario_(scenario), builtins_(builtins), rate_(here.rate), at_rest_(here.step.at_rest) {}

  /// The factor; `beyond` says why no larger one could be looked at.
  double from(double smallest, std::string& beyond) const {
    constexpr double scan = 1.1, precision = 1e-6;
    if (!is_stable(smallest)) return 0.0;
    double good = smallest, bad = good * scan;
    try {
      for (; is_stable(bad); bad *= scan) {
        if (bad > largest_factor) return std::numeric_limits<double>::infinity();
        good = bad;
      }
      while (bad > good * (1.0 + precision)) {
        const double middle = std::sqrt(good * bad);
        (is_stable(middle) ? good : bad) = middle;
      }
    } catch (const Error& error) {
      beyond = error.what();
    }
    return good;
  }

 private:
  bool is_stable(double factor) const {
    Scenario scaled = scenario_;
    scenario::scale_steps(scaled, builtins_, factor);
    SuperStep step = super_step(scaled, builtins_);
    step.at_rest = at_rest_;
    return stability::is_stable(step, step.radius(), rate_);
  }

  const Scenario& scenario_;
  const Builtins& builtins_;
  double rate_;
  int at_rest_;
};

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
  std::optional<std::size_t> first;
  for (std::size_t i = 0; i < step.steps.size(); ++i) {
    const auto before = [&](std::size_t other) {
      return slowest ? step.steps[i] < step.steps[other] : step.steps[i] > step.steps[other];
    };
    if (!step.sampled[i] && (!first || before(*first))) first = i;
  }
  return first.value_or(0);
}

}  // namespace

LargestStep largest_step(const Scenario& scenario, const Builtins& builtins) {
  if (scenario::by_impulse(scenario))
    throw Error(
        ErrorCode::not_supported,
        "an impulse coupling grows and dies out by turns as steps change, by up to 1e-3 each super-step");
  const Stability here = stability(scenario, builtins);
  const SuperStep& step = here.step;
  const double smallest = smallest_factor(here);
  std::string beyond;
  const double factor = Search(scenario, builtins, here).from(smallest, beyond);
  if (scenario.coordination.schedule == Schedule::Kind::parallel) {
    double largest = 0.0;
    for (std::size_t i = 0; i < step.steps.size(); ++i)
      if (!step.sampled[i]) largest = std::max(largest, step.own_steps[i]);
    return {factor, smallest, "communication step",
            scenario.coordination.communication_step.value_or(largest), beyond};
  }
  const std::size_t first = leader(scenario, step);
  return {factor, smallest, scenario.subsystems[first].name, step.own_steps[first], beyond};
}

}  // namespace tandem::stability
