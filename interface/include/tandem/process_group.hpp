// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sys/types.h>

#include <string>

namespace tandem {

/// A group of processes that ends with this one, however that ends. A shell in it waits for the end of its
/// standard input, which only this process holds open, and then kills the group. (What Linux has for that,
/// PR_SET_PDEATHSIG, reaches a program alone and not what it starts.)
class ProcessGroup {
 public:
  /// For `program`, as errors call it. Throws Error(input_output).
  explicit ProcessGroup(const std::string& program);
  /// Kills what is left in it.
  ~ProcessGroup();
  ProcessGroup(const ProcessGroup&) = delete;
  ProcessGroup& operator=(const ProcessGroup&) = delete;

  void signal(int number) const noexcept;
  pid_t number() const { return number_; }

 private:
  pid_t number_ = -1;  ///< of the group, and of the shell that leads it
  int held_open_ = -1;
};

/// Throws Error(input_output) with what `errno` says.
[[noreturn]] void fail_to_start(const std::string& program, const char* what);

}  // namespace tandem
