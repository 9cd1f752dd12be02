// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/interrupt.hpp"

#include <csignal>

namespace tandem::cli {
namespace {

volatile std::sig_atomic_t seen = 0;

extern "C" void note_signal(int signal) {
  seen = 1;
  static_cast<void>(std::signal(signal, SIG_DFL));
}

}  // namespace

InterruptGuard::InterruptGuard() {
  seen = 0;
  static_cast<void>(std::signal(SIGINT, note_signal));
  static_cast<void>(std::signal(SIGTERM, note_signal));
}

InterruptGuard::~InterruptGuard() {
  static_cast<void>(std::signal(SIGINT, SIG_DFL));
  static_cast<void>(std::signal(SIGTERM, SIG_DFL));
}

bool InterruptGuard::interrupted() { return seen != 0; }

}  // namespace tandem::cli
