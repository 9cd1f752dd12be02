// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <benchmark/benchmark.h>

#include "four_bar/linkage.hpp"
#include "tandem/mbs/formulations/index3.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::bench {

/// Steps of 1.25 ms of the linkage before its first flat position, over and over. Threads share loops from a
/// size on at which they lose, so that it is seen where they gain.
class LinkageSteps {
 public:
  explicit LinkageSteps(int loops, int threads = 1)
      : linkage_(mbs::read_mechanism("four_bar", four_bar::text(loops))),
        stepper_(linkage_, {.penalty = 1e8, .tolerance = 1e-5, .threads = threads, .threads_from = 1000}),
        start_(linkage_.described_state()) {
    stepper_.start(start_);
    now_ = start_;
  }
  int variables() const { return linkage_.structure().variables; }
  void step() {
    if (now_.time > 0.5) now_ = start_;
    stepper_.step(now_, h, now_.time + h);
  }

 private:
  static constexpr double h = 1.25e-3;
  mbs::Mechanism linkage_;
  mbs::Index3 stepper_;
  mbs::State start_, now_;
};

}  // namespace tandem::bench
