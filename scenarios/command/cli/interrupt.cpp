// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/interrupt.hpp"

#include <unistd.h>

#include <csignal>
#include <string_view>

#include "tandem/library_file.hpp"

namespace tandem::cli {
namespace {

volatile std::sig_atomic_t seen = 0;
volatile std::sig_atomic_t hears_hangup = 0;  ///< not under nohup

void leave_to_system() {
  static_cast<void>(std::signal(SIGINT, SIG_DFL));
  static_cast<void>(std::signal(SIGTERM, SIG_DFL));
  if (hears_hangup) static_cast<void>(std::signal(SIGHUP, SIG_DFL));
}

constexpr unsigned seconds_to_wait = 2;

/// A call that runs now may last, or never end.
extern "C" void tell_waiting(int) {
  constexpr std::string_view text =
      "tandem: interrupted, and waits for a call that runs to end; a second signal ends all at once\n";
  static_cast<void>(!::write(STDERR_FILENO, text.data(), text.size()));
}

extern "C" void note_signal(int) {
  seen = 1;
  leave_to_system();
  if (LibraryCall::has_faulted()) return;  // the alarm is that of its end
  static_cast<void>(std::signal(SIGALRM, tell_waiting));
  ::alarm(seconds_to_wait);
}

}  // namespace

InterruptGuard::InterruptGuard() {
  seen = 0;
  static_cast<void>(std::signal(SIGINT, note_signal));
  static_cast<void>(std::signal(SIGTERM, note_signal));
  hears_hangup = std::signal(SIGHUP, note_signal) == SIG_IGN ? 0 : 1;
  if (!hears_hangup) static_cast<void>(std::signal(SIGHUP, SIG_IGN));
}

InterruptGuard::~InterruptGuard() {
  leave_to_system();
  if (seen != 0 && !LibraryCall::has_faulted()) ::alarm(0);
}

bool InterruptGuard::interrupted() { return seen != 0; }

}  // namespace tandem::cli
