// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/interrupt.hpp"

#include <csignal>

namespace tandem::cli {
namespace {

volatile std::sig_atomic_t seen = 0;
volatile std::sig_atomic_t hears_hangup = 0;  ///< not under nohup

void leave_to_system() {
  static_cast<void>(std::signal(SIGINT, SIG_DFL));
  static_cast<void>(std::signal(SIGTERM, SIG_DFL));
  if (hears_hangup) static_cast<void>(std::signal(SIGHUP, SIG_DFL));
}

extern "C" void note_signal(int) {
  seen = 1;
  leave_to_system();
}

}  // namespace

InterruptGuard::InterruptGuard() {
  seen = 0;
  static_cast<void>(std::signal(SIGINT, note_signal));
  static_cast<void>(std::signal(SIGTERM, note_signal));
  hears_hangup = std::signal(SIGHUP, note_signal) == SIG_IGN ? 0 : 1;
  if (!hears_hangup) static_cast<void>(std::signal(SIGHUP, SIG_IGN));
}

InterruptGuard::~InterruptGuard() { leave_to_system(); }

bool InterruptGuard::interrupted() { return seen != 0; }

}  // namespace tandem::cli
