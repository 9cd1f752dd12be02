// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/wire/channel.hpp"

namespace tandem::wire {

Deadline in_seconds(double seconds) {
  using Clock = std::chrono::steady_clock;
  if (!(seconds < 1e9)) return Deadline::max();
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

}  // namespace tandem::wire
