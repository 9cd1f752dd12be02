// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <chrono>
#include <cstdint>

namespace tandem::scenario {

/// Tells between rounds, however long one takes, when some hundredth of a second has passed: only then the
/// clock is read.
class Pace {
 public:
  /// Whether the clock was read now.
  bool due() {
    if (++rounds_ < wait_) return false;
    const auto now = Clock::now();
    wait_ = now - read_ < every ? 2 * wait_ : std::max<std::int64_t>(1, wait_ / 2);
    rounds_ = 0;
    read_ = now;
    return true;
  }
  /// Since construction [s].
  double seconds() const { return std::chrono::duration<double>(Clock::now() - began_).count(); }
  /// The same when due() was true last.
  double seconds_read() const { return std::chrono::duration<double>(read_ - began_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds every{10};
  std::int64_t rounds_ = 0, wait_ = 1;  ///< since the clock was read; to let pass until it is read again
  Clock::time_point began_ = Clock::now(), read_ = began_;
};

}  // namespace tandem::scenario
