// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "timing.hpp"

#include "tandem/output/processor_time.hpp"
#include "tandem/scenario/assembly.hpp"

namespace tandem::study {
namespace {

Timing timed(scenario::Assembly& assembly) {
  assembly.initialize();
  const Stopwatch watch;
  while (assembly.coordinator().round()) {
  }
  return watch.read();
}

}  // namespace

Stopwatch::Stopwatch() : began_(std::chrono::steady_clock::now()), processor_(output::processor_time()) {}

Timing Stopwatch::read() const {
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - began_;
  return {seconds.count(), output::processor_time() - processor_};
}

Timing least_time(const scenario::Scenario& scenario, const Builtins& builtins, int repetitions,
                  Timing least) {
  for (int k = 1; k < repetitions; ++k) {
    scenario::Assembly assembly(scenario, builtins);
    const Timing one = timed(assembly);
    if (one.seconds < least.seconds) least = one;
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
