// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What a turn costs among many subsystems, and what threads gain there.
#include <fmt/format.h>

#include "bench/bench.hpp"
#include "bench/network.hpp"

namespace tandem::bench {
namespace {

std::vector<Network::Setting> sizes() {
  std::vector<Network::Setting> all;
  for (const char* schedule : {"slowest-first", "parallel"})
    for (const char* topology : {"pairs", "ring", "hub"})
      for (const int count : {2, 20, 200, 2000, 20000}) all.push_back({topology, schedule, count});
  for (const char* schedule : {"slowest-first", "parallel"})
    for (const int count : {3, 30, 300, 3000}) all.push_back({"sampled", schedule, count});
  return all;
}

/// 16 pairs; an operation takes some 3 ns.
std::vector<Network::Setting> loads() {
  std::vector<Network::Setting> all;
  for (const char* schedule : {"slowest-first", "parallel"})
    for (const long operations : {0L, 300L, 1000L, 1700L, 5000L, 17000L, 170000L})
      for (const int threads : {1, 2}) all.push_back({"pairs", schedule, 32, operations, threads});
  return all;
}

struct Measured {
  double turns = 0.0, ns = 0.0;  ///< of a round; of a turn
};

std::map<std::string, Measured> of_turns(const std::vector<Network::Setting>& settings) {
  std::map<std::string, Measured> all;
  std::vector<Timing> timings;
  for (const auto& s : settings)
    timings.push_back({s.name(), [s, &all](benchmark::State& state) {
                         Network network(s);
                         const double before = network.turns();
                         for (auto _ : state) network.round();
                         all[s.name()].turns =
                             (network.turns() - before) / static_cast<double>(state.iterations());
                       }});
  for (const auto& [name, seconds] : measure(timings, 11, 0.05))
    all[name].ns = 1e9 * seconds / all[name].turns;
  return all;
}

}  // namespace

Table topologies() {
  const auto measured = of_turns(sizes());
  Table table({"topology", "schedule", "subsystems", "ns_per_turn", "turns_per_round"}, "topologies");
  for (const auto& s : sizes()) {
    const auto [turns, ns] = measured.at(s.name());
    table.add({s.topology, s.schedule, std::to_string(s.count), fmt::format("{:.1f}", ns),
               fmt::format("{:.1f}", turns)});
  }
  return table;
}

Table round_threads() {
  const auto measured = of_turns(loads());
  Table table({"schedule", "us_per_turn", "us_per_turn_two_threads", "speed_up"}, "round_threads");
  for (auto s : loads()) {
    if (s.threads == 1) continue;
    const double two = measured.at(s.name()).ns;
    s.threads = 1;
    const double one = measured.at(s.name()).ns;
    table.add({s.schedule, fmt::format("{:.3f}", 1e-3 * one), fmt::format("{:.3f}", 1e-3 * two),
               fmt::format("{:.2f}", one / two)});
  }
  return table;
}

}  // namespace tandem::bench
