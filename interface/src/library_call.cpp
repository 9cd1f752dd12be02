// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <pthread.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "tandem/error.hpp"
#include "tandem/library_file.hpp"

namespace tandem {
namespace {

std::atomic<pid_t> guarded_process = 0;  ///< not one that a library has made, which may end as it likes
constexpr int of_nobody = -2, not_yet = -1;
std::atomic<int> own_status = of_nobody;  ///< of a program that says when it ends
std::atomic<bool> parent_tells = false, bad_end = false;

}  // namespace

constinit thread_local const LibraryCall* LibraryCall::current_ = nullptr;

void LibraryCall::guard_exit() {
  static const bool done = [] {
    guarded_process = ::getpid();
    return std::atexit([] { refuse_exit(0); }) == 0 && std::at_quick_exit([] { refuse_exit(0); }) == 0 &&
           ::pthread_atfork(nullptr, nullptr, [] { guarded_process = 0; }) == 0;
  }();
  if (!done) throw Error(ErrorCode::internal, "no library is loaded, as the program's end can't be guarded");
}

void LibraryCall::begin_program() noexcept {
  own_status = not_yet;
  guard_faults();
}

void LibraryCall::set_told_by_parent(bool told) noexcept { parent_tells = told; }

bool LibraryCall::tells_itself() noexcept { return !parent_tells; }

void LibraryCall::note_bad_end() noexcept { bad_end = true; }

bool LibraryCall::was_bad_end() noexcept { return bad_end; }

void LibraryCall::end_program(int status) noexcept { own_status = status; }

bool LibraryCall::is_any_loaded() noexcept { return ::getpid() == guarded_process; }

void LibraryCall::refuse_rounding(int before) {
  std::fesetround(before);
  throw Error(ErrorCode::numerical,
              "it changed how numbers are rounded, which all subsystems here go by; allowed is to leave that "
              "as it was");
}

void LibraryCall::return_from_exit() noexcept {
  if (!is_any_loaded() || !tells_itself()) return;
  return_to_call(by_exit);
  leave_to_others(by_exit);
}

int LibraryCall::refuse_exit(int status) noexcept {
  if (!is_any_loaded()) return status;
  const bool its_own_end = own_status >= 0;
  if (its_own_end || !(current_ || own_status == not_yet)) return its_own_end ? own_status.load() : status;
  return_from_exit();
  const char* who = current_ ? current_->library_ : "a library that was loaded";
  own_status = tells_itself() ? 1 : ended_by_library;
  static_cast<void>(std::fflush(nullptr));
  if (!tells_itself()) ::_exit(ended_by_library);
  static_cast<void>(std::fprintf(stderr,
                                 "tandem: %s ended the program in the middle of %s; allowed is to return\n",
                                 who, current_ ? "a call" : "the work"));
  ::_exit(1);
}

}  // namespace tandem
