// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace tandem {

/// How a program is started. A descriptor of -1: the one of this process.
struct ProcessStart {
  std::vector<std::string> words;           ///< The program, looked for in PATH, and its arguments.
  int input = -1, output = -1, error = -1;  ///< Its standard streams.
  int kept = -1;                            ///< Another descriptor, which it has under the same number.
  std::filesystem::path folder = {};        ///< Where it runs; empty: where this process does.
  std::vector<std::string> variables = {};  ///< "NAME=VALUE", besides those of this process.
  pid_t group = -1;                         ///< The process group that it joins; -1: the one of this process.
  std::string name = {};                    ///< What errors call it; empty: 'PROGRAM'.
};

/// Starts it and returns its number. Throws Error(input_output) that says why it can't be started.
pid_t start_process(const ProcessStart& start);

/// Waits for its end; the status is that of waitpid().
int end_of_process(pid_t process);

}  // namespace tandem
