// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Faults of libraries: signals that end the program where nobody takes them.
#include <pthread.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstring>

#include "tandem/error.hpp"
#include "tandem/library_file.hpp"

namespace tandem {
namespace {

std::atomic<pid_t> watched_process = 0;  ///< not one that is made from it
pthread_t first_thread;
std::atomic<bool> returns = false, faulted = false;
constexpr unsigned seconds_to_see = 2;   ///< for the calls to learn of a fault outside of them
constexpr unsigned seconds_to_end = 10;  ///< for a program of which a library may have left a lock closed

struct Fault {
  int signal;
  const char* what;
};
constexpr Fault faults[] = {{SIGSEGV, "reached for memory that is not there"},
                            {SIGBUS, "reached for memory that is not there"},
                            {SIGFPE, "divided by zero"},
                            {SIGILL, "has an instruction that this processor does not"},
                            {SIGABRT, "gave up (abort)"}};

const char* what(int signal) noexcept {
  for (const Fault& fault : faults)
    if (fault.signal == signal) return fault.what;
  return "made a fault";
}

void say(const char* text) noexcept {
  const auto written = ::write(STDERR_FILENO, text, std::strlen(text));
  static_cast<void>(written);
}

/// The program that has seen a fault is to end, and soon.
void limit_the_end() noexcept {
  if (faulted.exchange(true)) return;
  static_cast<void>(std::signal(SIGALRM, [](int) {
    say("tandem: a library has made a fault, and left the program unable to end its work\n");
    LibraryCall::end_program(1);
    ::_exit(1);
  }));
  ::alarm(seconds_to_end);
}

void wait_for_fault(unsigned seconds) noexcept {
  while (seconds > 0 && !faulted) seconds = ::sleep(seconds);
}

/// As without a handler.
void end_by(int signal) noexcept {
  static_cast<void>(std::signal(signal, SIG_DFL));
  ::raise(signal);
}

constinit thread_local const void* returned_to = nullptr;  ///< a call, which a fault ends once

}  // namespace

constinit std::atomic<int> LibraryCall::outside_ = 0;

void LibraryCall::return_from_faults() noexcept { returns = true; }

bool LibraryCall::has_faulted() noexcept { return faulted || outside_ != 0; }

/// Also of a stack that is at its end, in the thread that the program begins with. A handler that is there
/// already, a sanitizer's, keeps its place.
void LibraryCall::guard_faults() noexcept {
  static char other_stack[std::size_t{1} << 16];
  stack_t stack{};
  stack.ss_sp = other_stack;
  stack.ss_size = sizeof other_stack;
  ::sigaltstack(&stack, nullptr);
  watched_process = ::getpid();
  first_thread = ::pthread_self();
  struct sigaction ours {};
  ours.sa_handler = fault;
  ours.sa_flags = static_cast<int>(SA_ONSTACK | SA_NODEFER);
  for (const Fault& one : faults)
    if (struct sigaction before{};
        ::sigaction(one.signal, nullptr, &before) == 0 && before.sa_handler == SIG_DFL)
      ::sigaction(one.signal, &ours, nullptr);
}

void LibraryCall::return_to_call(int cause) noexcept {
  if (!returns || !current_ || !current_->back_ || returned_to == current_) return;
  returned_to = current_;
  limit_the_end();
  siglongjmp(*current_->back_, cause);
}

void LibraryCall::leave_to_others(int cause) noexcept {
  if (!returns || current_ || ::gettid() == ::getpid()) return;
  outside_ = cause;
  wait_for_fault(seconds_to_see);
  static std::atomic<bool> is_asked = false;
  if (!faulted && !is_asked.exchange(true))
    ::pthread_kill(first_thread, SIGABRT);  // its call may wait for this thread
  wait_for_fault(seconds_to_see);
  while (faulted) ::pause();
}

/// By calls alone that a handler may make. A fault where no library is loaded ends the program as it would
/// without a handler.
void LibraryCall::fault(int signal) noexcept {
  if (::getpid() != watched_process || !(current_ || is_any_loaded())) {
    end_by(signal);
    return;
  }
  return_to_call(signal);
  const bool is_first = ::gettid() == ::getpid();
  if (is_first && signal == SIGABRT && outside_ != 0)
    return;  // of leave_to_others; the call ends already, or there is none
  leave_to_others(signal);
  if (!tells_itself()) end_by(signal);
  say("tandem: ");
  say(current_ ? current_->library_ : "a library that was loaded, or tandem itself,");
  say(" ");
  say(what(signal));
  say(current_ ? " in a call\n" : " outside of a call\n");
  end_program(1);
  ::_exit(1);
}

void LibraryCall::refuse_fault(int signal) {
  limit_the_end();
  const bool besides = outside_ != 0;
  const int cause = besides ? outside_.load() : signal;
  const std::string who = besides ? "a thread beside the calls " : "it ",
                    done = cause == by_exit ? "ended the program; allowed is to return"
                                            : what(cause) + (" (signal " + std::to_string(cause) + ")");
  throw Error(ErrorCode::internal,
              who + done + (besides ? "; no library is called again" : "; it is not called again"));
}

}  // namespace tandem
