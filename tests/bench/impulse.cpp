// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "bench/bench.hpp"
#include "sources/all.hpp"
#include "tandem/scenario/assembly.hpp"

namespace tandem::bench {
namespace {

/// A scene by impulse, and by samples of the force.
struct Coupled {
  std::string name, file, ratio;  ///< ratio: the key that sets it
  std::vector<std::string> overrides;
};

std::vector<Coupled> couplings() {
  const std::string two_mass = "two_mass/impulse.toml", pendulum = "pushed_pendulum/pushed_pendulum.toml";
  const std::string ratio = "parameters.frequency_ratio", constant = "constants.ratio";
  const std::string surrogate = "coordination.carrier=surrogate",
                    stiffness = "coordination.coupling=impulse_stiffness";
  const std::vector<std::string> samples = {
      "coordination.coupling=signals", "coordination.schedule=slowest-first",
      "connections.reconstruction=lagrange3", "span.diverged_beyond=1e100"};
  return {
      {"two_mass by lagrange3", two_mass, ratio, samples},
      {"two_mass by impulse_plain", two_mass, ratio, {}},
      {"two_mass by impulse_plain (surrogate)", two_mass, ratio, {surrogate}},
      {"two_mass by impulse_stiffness", two_mass, ratio, {stiffness}},
      {"two_mass by impulse_stiffness (surrogate)", two_mass, ratio, {stiffness, surrogate}},
      {"pushed_pendulum by impulse_plain", pendulum, constant, {"coordination.coupling=impulse_plain"}},
      {"pushed_pendulum by impulse_plain (surrogate)",
       pendulum,
       constant,
       {"coordination.coupling=impulse_plain", surrogate}},
      {"pushed_pendulum by impulse_taylor", pendulum, constant, {"coordination.coupling=impulse_taylor"}}};
}

struct Spent {
  double seconds = 1e9;
  std::int64_t fast_steps = 0, exchanges = 0;
};

Spent spent(const scenario::Scenario& scenario, const Builtins& builtins) {
  using Clock = std::chrono::steady_clock;
  scenario::Assembly assembly(scenario, builtins);
  assembly.initialize();
  const auto begin = Clock::now();
  while (assembly.coordinator().round()) {
  }
  Spent all{std::chrono::duration<double>(Clock::now() - begin).count()};
  all.fast_steps = assembly.coordinator().effort(0).steps;
  for (int i = 0; i < assembly.topology().size(); ++i)
    all.exchanges += assembly.coordinator().effort(i).exchanges;
  return all;
}

}  // namespace

/// 100 fast cycles, in turns; the least of each.
Table impulse(const Tick& tick) {
  constexpr int repetitions = 100;
  Table table({"coupling", "frequency_ratio", "exchanges", "ms", "ns_per_fast_step", "over_lagrange3"});
  const Builtins builtins = all_sources();
  const auto all = couplings();
  const std::vector<std::string> ratios = {"30", "100", "1000"};
  for (const std::string& ratio : ratios) {
    std::vector<Spent> least(all.size());
    for (int i = 0; i < repetitions; ++i)
      for (std::size_t k = 0; k < all.size(); ++k) {
        auto overrides = all[k].overrides;
        overrides.insert(overrides.end(), {all[k].ratio + "=" + ratio, "span.stop=100"});
        const Spent one =
            spent(scenario::read(std::filesystem::path("scenarios") / all[k].file, overrides), builtins);
        if (one.seconds < least[k].seconds) least[k] = one;
      }
    for (std::size_t k = 0; k < all.size(); ++k)
      table.add({all[k].name, ratio, std::to_string(least[k].exchanges),
                 fmt::format("{:.3f}", 1e3 * least[k].seconds),
                 fmt::format("{:.0f}", 1e9 * least[k].seconds / static_cast<double>(least[k].fast_steps)),
                 fmt::format("{:.2f}", least[k].seconds / least[0].seconds)});
    tick(static_cast<double>(&ratio - ratios.data() + 1) / static_cast<double>(ratios.size()));
  }
  return table;
}

}  // namespace tandem::bench
