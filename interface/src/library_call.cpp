// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <pthread.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "tandem/library_file.hpp"

namespace tandem {
namespace {

pid_t guarded_process = 0;  ///< not one that a library has made, which may end as it likes

}  // namespace

constinit thread_local const char* LibraryCall::current_ = nullptr;

void LibraryCall::guard_exit() {
  static const bool done = [] {
    guarded_process = ::getpid();
    std::atexit(refuse_exit);
    std::at_quick_exit(refuse_exit);
    return ::pthread_atfork(nullptr, nullptr, [] {
             current_ = nullptr;
             guarded_process = ::getpid();
           }) == 0;
  }();
  static_cast<void>(done);
}

void LibraryCall::refuse_exit() noexcept {
  if (!current_ || ::getpid() != guarded_process) return;
  std::fflush(nullptr);
  std::fprintf(stderr, "tandem: %s ended the program in the middle of a call; allowed is to return\n",
               current_);
  current_ = nullptr;
  ::_exit(1);
}

}  // namespace tandem
