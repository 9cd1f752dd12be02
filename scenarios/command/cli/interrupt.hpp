// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tandem::cli {

/// While it lives, Ctrl-C (SIGINT), SIGTERM and SIGHUP (unless it is ignored) set a flag instead of ending
/// the process; a second one ends it at once.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
  static bool interrupted();
};

}  // namespace tandem::cli
