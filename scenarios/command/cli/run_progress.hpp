// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <chrono>

namespace tandem::cli {

/// Lines on standard error: of a run that takes longer than a second how far it has come, of every run that
/// comes to its end what it has simulated, in which time, and the real-time factor.
class RunProgress {
 public:
  RunProgress(double t_start, double t_stop, bool shown);
  ~RunProgress();
  RunProgress(const RunProgress&) = delete;
  RunProgress& operator=(const RunProgress&) = delete;

  /// time [s]: how far the run has come.
  void show(double time);
  /// The last line, of a run that has come to this time [s] in so many seconds.
  void end(double time, double seconds);

 private:
  using Time = std::chrono::steady_clock::time_point;
  double t_start_, t_stop_;
  bool shown_, terminal_, open_line_ = false;
  Time began_, drawn_;
};

}  // namespace tandem::cli
