// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/indicators.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "bench/bench.hpp"
#include "sources/all.hpp"
#include "tandem/scenario/assembly.hpp"

namespace tandem::bench {
namespace {

struct Scene {
  std::string name, file;
  std::vector<std::string> overrides;
  int repetitions;
};

std::vector<Scene> scenes() {
  const std::string step = "subsystems.engine.parameters.step=";
  return {{"two_mass at ratio 2", "two_mass/two_mass.toml", {"parameters.frequency_ratio=2"}, 400},
          {"two_mass at ratio 30", "two_mass/two_mass.toml", {"parameters.frequency_ratio=30"}, 400},
          {"two_mass at ratio 100", "two_mass/two_mass.toml", {"parameters.frequency_ratio=100"}, 400},
          {"engine_linkage", "engine_linkage/engine_linkage.toml", {"span.stop=3"}, 80},
          {"kart", "kart/kart.toml", {"span.stop=2"}, 40},
          {"drive", "drive/drive.toml", {}, 60}};
}

/// Rounds of a run, with indicators or without.
class Trial {
 public:
  Trial(const scenario::Scenario& scenario, const Builtins& builtins, bool indicates)
      : assembly_(scenario, builtins) {
    if (indicates) assembly_.coordinator().observe((indicators_ = assembly_.indicators()).get());
    assembly_.initialize();
  }
  double seconds() {
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    while (assembly_.coordinator().round()) {
    }
    return std::chrono::duration<double>(Clock::now() - begin).count();
  }

  /// Of each connection the steps in whose middle its defect is taken, all together.
  double looked_at() const {
    double count = 0.0;
    const auto steps = [this](int who) { return assembly_.coordinator().effort(who).steps; };
    for (const auto& one : indicators_->connections()) {
      const Line& line = assembly_.topology().lines()[static_cast<std::size_t>(one.line)];
      const bool sampled = assembly_.topology().info(line.reader).abilities.sampled;
      count += static_cast<double>(sampled ? steps(line.reader)
                                           : std::max(steps(line.source), steps(line.reader)));
    }
    return count;
  }
  const Indicators& indicators() const { return *indicators_; }

 private:
  std::unique_ptr<Indicators> indicators_;
  scenario::Assembly assembly_;
};

}  // namespace

/// Whole runs, in turns with and without; the least of each.
Table indicators(const Tick& tick) {
  Table table({"scene", "connections", "links", "steps", "ms_without", "ms_with", "share",
               "ns_per_connection_and_step"});
  const Builtins builtins = all_sources();
  const auto all = scenes();
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Scene& scene = all[k];
    const auto scenario = scenario::read(std::filesystem::path("scenarios") / scene.file, scene.overrides);
    double without = 1e9, with = 1e9, looked_at = 0.0;
    std::size_t connections = 0, links = 0;
    for (int i = 0; i < scene.repetitions; ++i) {
      without = std::min(without, Trial(scenario, builtins, false).seconds());
      Trial trial(scenario, builtins, true);
      with = std::min(with, trial.seconds());
      looked_at = trial.looked_at();
      connections = trial.indicators().connections().size(), links = trial.indicators().links().size();
    }
    table.add({scene.name, std::to_string(connections), std::to_string(links),
               fmt::format("{:.0f}", looked_at), fmt::format("{:.4f}", 1e3 * without),
               fmt::format("{:.4f}", 1e3 * with), fmt::format("{:.4f}", with / without - 1.0),
               fmt::format("{:.1f}", 1e9 * (with - without) / looked_at)});
    tick(static_cast<double>(k + 1) / static_cast<double>(all.size()));
  }
  return table;
}

}  // namespace tandem::bench
