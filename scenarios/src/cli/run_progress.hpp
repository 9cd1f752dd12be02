// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <chrono>
#include <cstdint>

namespace tandem::cli {

/// Lines on standard error: of a run that takes longer than a second how far it has come, of every run that
/// comes to its end what it has simulated, in which time, and the real-time factor. To be asked after every
/// round; it reads the clock only about a hundred times a second, however long a round takes.
class RunProgress {
 public:
  RunProgress(double t_start, double t_stop, bool shown);
  ~RunProgress();
  RunProgress(const RunProgress&) = delete;
  RunProgress& operator=(const RunProgress&) = delete;

  bool due() { return ++rounds_ >= wait_; }
  /// time [s]: how far the run has come. When due() says so.
  void show(double time);
  /// The last line, of a run that has come to this time [s].
  void end(double time);
  double seconds() const;  ///< since construction

 private:
  using Time = std::chrono::steady_clock::time_point;
  double t_start_, t_stop_;
  bool shown_, terminal_, open_line_ = false;
  std::int64_t rounds_ = 0, wait_ = 1;  ///< since the clock was read; to let pass until it is read again
  Time began_, read_, drawn_;
};

}  // namespace tandem::cli
