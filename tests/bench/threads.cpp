// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <memory>
#include <thread>

#include "bench/bench.hpp"
#include "bench/linkage_steps.hpp"

namespace tandem::bench {
namespace {

std::string name(int loops, int threads) { return fmt::format("{}/{}", loops, threads); }

Timing thread_timing(int loops, int threads) {
  const auto linkage = std::make_shared<LinkageSteps>(loops, threads);
  return {name(loops, threads), [linkage](benchmark::State& state) {
            for ([[maybe_unused]] auto _ : state) linkage->step();
          }};
}

}  // namespace

Table threads() {
  const std::vector<int> sizes = {100, 400, 800, 1600, 4000, 10'000, 20'000};
  std::vector<int> counts;
  for (int k = 1; k <= static_cast<int>(std::thread::hardware_concurrency()); k *= 2) counts.push_back(k);
  std::vector<Timing> timings;
  for (const int loops : sizes)
    for (const int count : counts) timings.push_back(thread_timing(loops, count));
  auto seconds = measure(timings, 15, 0.02);
  Table table({"loops", "variables", "threads", "ns_per_step_variable", "speed_up"});
  for (const int loops : sizes)
    for (const int count : counts) {
      const int n = 2 * loops + 2;
      table.add({std::to_string(loops), std::to_string(n), std::to_string(count),
                 fmt::format("{:.1f}", 1e9 * seconds[name(loops, count)] / n),
                 fmt::format("{:.2f}", seconds[name(loops, 1)] / seconds[name(loops, count)])});
    }
  return table;
}

}  // namespace tandem::bench
