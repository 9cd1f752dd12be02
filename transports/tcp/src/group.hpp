// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sys/types.h>

#include <string>

namespace tandem::tcp {

/// A group of processes that ends with this one, however that ends. A shell in it waits for the end of its
/// standard input, which only this process holds open, and then kills the group. (What Linux has for that,
/// PR_SET_PDEATHSIG, reaches a program alone and not what it starts.)
class Group {
 public:
  /// For `program`, as errors call it. Throws Error(input_output).
  explicit Group(const std::string& program);
  /// Kills what is left in it.
  ~Group();
  Group(const Group&) = delete;
  Group& operator=(const Group&) = delete;

  /// Called in a child process between fork and exec; what can't join ends.
  void join() const noexcept;
  void signal(int number) const noexcept;

 private:
  pid_t number_ = -1;  ///< of the group, and of the shell that leads it
  int held_open_ = -1;
};

/// Throws Error(input_output) with what `errno` says.
[[noreturn]] void fail_to_start(const std::string& program, const char* what);

}  // namespace tandem::tcp
