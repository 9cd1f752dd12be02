// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "timing.hpp"

#include <chrono>

#include "tandem/output/processor_time.hpp"
#include "tandem/scenario/assembly.hpp"

namespace tandem::study {
namespace {

Timing timed(scenario::Assembly& assembly) {
  assembly.initialize();
  const double processor = output::processor_time();
  const auto begin = std::chrono::steady_clock::now();
  while (assembly.coordinator().round()) {
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  return {seconds.count(), output::processor_time() - processor};
}

}  // namespace

Timing least_time(const scenario::Scenario& scenario, const Builtins& builtins, int repetitions) {
  Timing least{};
  for (int k = 0; k < repetitions; ++k) {
    scenario::Assembly assembly(scenario, builtins);
    const Timing one = timed(assembly);
    if (k == 0 || one.seconds < least.seconds) least = one;
  }
  return least;
}

std::map<std::string, double> shares(const scenario::Scenario& scenario, const Builtins& builtins) {
  scenario::Assembly assembly(scenario, builtins, true);
  const Timing whole = timed(assembly);
  std::map<std::string, double> shares;
  for (int i = 0; i < assembly.topology().size(); ++i)
    shares[assembly.topology().name(i)] = assembly.coordinator().effort(i).seconds / whole.seconds;
  return shares;
}

}  // namespace tandem::study
