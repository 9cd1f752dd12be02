// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "bench/bench.hpp"
#include "two_mass/experiment.hpp"

namespace tandem::bench {
namespace {

using two_mass::Scheme;

std::vector<two_mass::Case> cases() {
  std::vector<two_mass::Case> list;
  for (const double ratio : {30.0, 100.0})
    for (const Scheme& s :
         {Scheme{"slowest-first", "lagrange3", "lagrange3"},
          Scheme{"fastest-first", "lagrange3", "lagrange3"}, Scheme{"parallel", "lagrange3", "lagrange3"},
          Scheme{"staggered", "matched_hold", "matched_hold"}, Scheme{"monolithic", "", ""}})
      list.push_back({s, ratio});
  return list;
}

}  // namespace

/// Whole runs of 100 fast cycles; the sides' parts are those of the run with the least total, by the clock
/// around each call, so that part holds the clock's own cost too.
Table two_mass() {
  constexpr int repetitions = 100;
  Table table({"schedule", "to_fast", "to_slow", "frequency_ratio", "ms", "ms_profiled", "fast_share",
               "slow_share", "coordinator_share", "over_monolithic"});
  for (const double ratio : {30.0, 100.0}) {
    std::vector<two_mass::Case> group;
    for (const two_mass::Case& c : cases())
      if (c.frequency_ratio == ratio) group.push_back(c);
    std::vector<double> least(group.size(), 1e9);
    std::vector<two_mass::Profile> profiles(group.size(), {1e9, 0.0, 0.0});
    for (int i = 0; i < repetitions; ++i)
      for (std::size_t k = 0; k < group.size(); ++k) {
        least[k] = std::min(least[k], two_mass::time_case(group[k]));
        const auto profile = two_mass::profile_case(group[k]);
        if (profile.total < profiles[k].total) profiles[k] = profile;
      }
    for (std::size_t k = 0; k < group.size(); ++k) {
      const auto& [total, fast, slow] = profiles[k];
      const Scheme& s = group[k].scheme;
      table.add({s.schedule, s.to_fast, s.to_slow, fmt::format("{}", ratio),
                 fmt::format("{:.4f}", 1e3 * least[k]), fmt::format("{:.4f}", 1e3 * total),
                 fmt::format("{:.3f}", fast / total), fmt::format("{:.3f}", slow / total),
                 fmt::format("{:.3f}", (total - fast - slow) / total),
                 fmt::format("{:.2f}", least[k] / least.back())});
    }
  }
  return table;
}

}  // namespace tandem::bench
