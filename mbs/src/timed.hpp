// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/mbs/profile.hpp"

namespace tandem::mbs {

/// From here to the end of the block time counts for a task. Not within another.
#ifdef TANDEM_PROFILE
class Timed {
 public:
  explicit Timed(Task task);
  ~Timed();
  Timed(const Timed&) = delete;
  Timed& operator=(const Timed&) = delete;

 private:
  Task task_;
  double began_;
};
#else
struct [[maybe_unused]] Timed {
  explicit constexpr Timed(Task) {}
};
#endif

}  // namespace tandem::mbs
