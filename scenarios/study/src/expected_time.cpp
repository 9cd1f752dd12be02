// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "expected_time.hpp"

#include <algorithm>
#include <chrono>

#include "tandem/error.hpp"

namespace tandem::study {
namespace {

using Clock = std::chrono::steady_clock;

double slowest_time(const scenario::Assembly& run) {
  double slowest = run.coordinator().time(0);
  for (int i = 1; i < run.topology().size(); ++i) slowest = std::min(slowest, run.coordinator().time(i));
  return slowest;
}

}  // namespace

double expected_seconds(scenario::Assembly& run, double start, double stop, double patience) {
  const auto began = Clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - began).count(); };
  try {
    while (seconds() < patience && run.coordinator().round()) continue;
  } catch (const Error&) {  // it ends there
    return seconds();
  }
  const double spent = seconds(), share = (slowest_time(run) - start) / (stop - start);
  return share > 0.0 ? spent / std::min(share, 1.0) : spent;
}

}  // namespace tandem::study
