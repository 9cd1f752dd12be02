// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/profile.hpp"

#include <fmt/format.h>

#include <numeric>

#include "bench/bench.hpp"
#include "bench/linkage_steps.hpp"

namespace tandem::bench {
namespace {

using Seconds = std::array<double, mbs::task_count>;

double sum(const Seconds& s) { return std::accumulate(s.begin(), s.end(), 0.0); }

/// Of the steps whose sum was least.
Seconds least(LinkageSteps& linkage, int steps) {
  Seconds best{};
  for (int repetition = 0; repetition < 20; ++repetition) {
    mbs::clear_profile();
    for (int k = 0; k < steps; ++k) linkage.step();
    if (repetition == 0 || sum(mbs::profile()) < sum(best)) best = mbs::profile();
  }
  return best;
}

}  // namespace

Table profile() {
  Table table({"loops", "variables", "task", "ns_per_step_variable", "share"});
  for (const int loops : {5, 40, 500, 4000}) {
    LinkageSteps linkage(loops);
    const int steps = 20'000 / linkage.variables() + 1;
    const Seconds seconds = least(linkage, steps);
    for (std::size_t k = 0; k < mbs::task_count; ++k)
      table.add({std::to_string(loops), std::to_string(linkage.variables()), mbs::task_names[k],
                 fmt::format("{:.1f}", 1e9 * seconds[k] / steps / linkage.variables()),
                 fmt::format("{:.3f}", seconds[k] / sum(seconds))});
  }
  return table;
}

}  // namespace tandem::bench
