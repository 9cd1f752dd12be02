// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sys/types.h>

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include "tandem/process_group.hpp"

namespace tandem::mbs {

using Instant = std::chrono::steady_clock::time_point;

/// A program that is talked to in lines: what it reads from its standard input and writes to its standard
/// output and error. It is killed with this object, or with this process, and all that it has started with
/// it. POSIX.
class Process {
 public:
  /// Throws Error(input_output) if it can't be started.
  explicit Process(std::vector<std::string> command);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  enum class Outcome { ok, late, ended };
  Outcome write(std::string_view text, Instant deadline);
  /// The next line without its end. What came before the end of the output without one is a line too.
  Outcome read_line(std::string& line, Instant deadline);
  /// Ends it if it still runs, and tells how it ended: "exit status 1", "signal 9".
  std::string end();

 private:
  bool wait_for(short events, Instant deadline) const;

  ProcessGroup group_;
  int socket_ = -1;
  pid_t child_ = -1;
  std::string received_, how_it_ended_;
};

}  // namespace tandem::mbs
