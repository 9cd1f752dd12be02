// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "adapters.hpp"
#include "run_bench.hpp"
#include "scheme.hpp"
#include "two_mass/masses.hpp"

namespace tandem::test {

/// A run of the two-mass test with its own integrators, of which each sample is kept. Subsystem 0 is the fast
/// side.
struct MassPair {
  Scheme scheme;
  double frequency_ratio = 30.0;
  double t_start = 0.0, t_stop = 20.3;
  StartKind start = StartKind::automatic;
  Lag lag_to_slow = Lag::none;
  bool swapped = false;  ///< the fast side is treated as the slow one
  Wrap wrap = as_it_is;
};

class MassPairRun {
 public:
  explicit MassPairRun(const MassPair& what)
      : fast_(what.wrap(fast(what))), slow_(what.wrap(slow(what))), what_(what) {
    bench_.add("fast", *fast_).add("slow", *slow_).schedule(what.scheme.schedule);
    bench_.connect("slow.x2", "fast.x2", what.scheme.to_fast)
        .connect("fast.x1", "slow.x1", what.scheme.to_slow, what.lag_to_slow);
    if (what.swapped) bench_.coordination.order = {"fast", "slow"};
    bench_.coordination.start = what.start;
    bench_.coordination.diverged_beyond = std::numeric_limits<double>::infinity();  // some schemes do
  }
  const std::vector<Recording::Rows>& run() { return bench_.run(what_.t_stop, what_.t_start).all(); }
  RunBench& bench() { return bench_; }

 private:
  static two_mass::Model model(const MassPair& what) {
    two_mass::Settings settings;
    settings.frequency_ratio = what.frequency_ratio;
    settings.phase1 = settings.phase2 = 0.8;  // a start where no velocity is zero
    return two_mass::Model(settings);
  }
  static std::unique_ptr<Subsystem> fast(const MassPair& what) {
    return std::make_unique<FixedStep<two_mass::FastMass>>(two_mass::FastMass(model(what), {}));
  }
  static std::unique_ptr<Subsystem> slow(const MassPair& what) {
    return std::make_unique<FixedStep<two_mass::SlowMass>>(two_mass::SlowMass(model(what), {}));
  }

  std::unique_ptr<Subsystem> fast_, slow_;
  MassPair what_;
  RunBench bench_;
};

}  // namespace tandem::test
