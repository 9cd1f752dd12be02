// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <chrono>
#include <cstddef>
#include <string>

namespace tandem::output {

/// To standard error, at once: how far the work has come. What can't be written there does not end the work.
void show_progress(const std::string& text);

/// A bar on standard error with an estimate of the time left, drawn anew at most ten times a second; a line
/// now and then where standard error is no terminal.
class Progress {
 public:
  /// total: number of pieces of work, above 0. shown = false draws nothing.
  Progress(std::string what, std::size_t total, bool shown);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void update(std::size_t done);

 private:
  void draw(std::size_t done);
  std::string what_;
  std::size_t total_, first_done_ = 0;
  bool shown_, terminal_, begun_ = false, open_line_ = false;
  std::chrono::steady_clock::time_point started_, drawn_;
};

}  // namespace tandem::output
