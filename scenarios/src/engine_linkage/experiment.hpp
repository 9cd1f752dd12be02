// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "engine_linkage/coupled.hpp"
#include "engine_linkage/truth.hpp"

namespace tandem::engine_linkage {

struct Case {
  Scheme scheme;
  int loops = 1;
  double engine_step = 1e-4, step_ratio = 1.0;  ///< [s]; the linkage's step in those of the engine
  double linkage_step() const { return engine_step * step_ratio; }
};

inline constexpr double t_stop = 30.0;  // [s]

/// Differences of the bar's speed from the truth, at the linkage's own steps [rad/s]. A run is unstable if a
/// side gives up or the difference exceeds 10 rad/s.
struct Outcome {
  double largest = 0.0, rms = 0.0;
  long exchanges = 0;  ///< of both sides
  bool stable = true;
  std::string note = {};  ///< why not
};
Outcome run_case(const Case& c, const engine::Description& engine, const Truth& truth);

/// [s] of a run of `duration` without its start.
struct Elapsed {
  double total = 0.0, engine = 0.0, linkage = 0.0;  ///< the rest is the coordinator's
  long exchanges = 0;
};
Elapsed time_case(const Case& c, const engine::Description& engine, double duration);

}  // namespace tandem::engine_linkage
