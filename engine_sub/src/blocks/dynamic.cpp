// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "kinds.hpp"

namespace tandem::engine {
namespace {

/// state' = input from `initial` on; back to `reset_to` where `reset` rises above 0.
void integrator(Lowering& to, Arguments& a) {
  const int state = to.state(a.wire("input"));
  to.start(state, a.wire("initial", 0.0));
  if (a.has("reset")) {
    const int event = to.crossing(a.wire("reset"), Crossing::Direction::rising);
    to.update(event, state, a.wire("reset_to", 0.0));
  }
  to.define("", state);
}

/// time y' = gain input - y.
void lag(Lowering& to, Arguments& a) {
  const double rate = 1.0 / a.positive("time");
  const int state = to.state(-1);
  to.start(state, a.wire("initial", 0.0));
  to.signals[state].rate = to.sum({a.wire("input"), state}, {rate * a.number("gain", 1.0), -rate});
  to.define("", state);
}

}  // namespace

const std::vector<BlockKind> dynamic_blocks = {{"integrator", integrator}, {"lag", lag}};

}  // namespace tandem::engine
