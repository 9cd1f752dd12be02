// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "command.hpp"

namespace tandem::test {

/// `tandem` with these arguments in `folder`, while the test goes on.
class Background {
 public:
  Background(const Scratch& folder, std::vector<std::string> arguments)
      : err_(folder.path() / "background_err.txt") {
    arguments.insert(arguments.begin(), TANDEM_COMMAND);
    std::vector<char*> words;
    for (std::string& word : arguments) words.push_back(word.data());
    words.push_back(nullptr);
    process_ = fork();
    if (process_ != 0) return;
    if (chdir(folder.path().c_str()) == 0 && freopen(err_.c_str(), "w", stderr))
      execv(words[0], words.data());
    _exit(9);
  }
  ~Background() {
    if (process_ > 0) kill(process_, SIGKILL), waitpid(process_, nullptr, 0);
  }
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  /// Waits until the file is there and not empty. False if the process ended before.
  bool wait_for_file(const std::filesystem::path& file) {
    int status = 0;
    std::error_code none;
    while (!(std::filesystem::file_size(file, none) > 0 && !none))
      if (waitpid(process_, &status, WNOHANG) != 0) return process_ = -1, false;
    return true;
  }
  /// Signals it (SIGINT: as Ctrl-C does) and waits for its end: the exit status, -1 for a signal.
  int end_by(int signal) {
    kill(process_, signal);
    return end();
  }
  /// Waits for its end, likewise.
  int end() {
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  pid_t process() const { return process_; }
  std::string err() const { return read_text(err_); }

 private:
  std::filesystem::path err_;
  pid_t process_ = -1;
};

}  // namespace tandem::test
