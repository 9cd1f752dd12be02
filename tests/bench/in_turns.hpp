// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <vector>

namespace tandem::bench {

/// Processors that the two ends of an exchange are pinned to: the first two that this process may use, or the
/// only one.
struct Places {
  int here, there;
};
Places places();
/// The calling thread runs on that processor from now on.
void pin(int processor);

/// Seconds of an exchange.
struct RoundTrip {
  double median, p99;
};
struct InTurns {
  RoundTrip tandem, raw;
};

/// Two kinds of exchange in turns, `count` of each in turns of 50, timed in batches of `batch`; what wakes up
/// at the beginning of a turn is not timed. Runs in a thread of its own, pinned to places().here.
InTurns measure_in_turns(const std::function<void()>& tandem, const std::function<void()>& raw, int count,
                         int batch = 1);

}  // namespace tandem::bench
