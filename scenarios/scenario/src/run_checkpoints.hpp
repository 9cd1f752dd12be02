// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <optional>

#include "tandem/scenario/checkpoint.hpp"

namespace tandem::scenario {

/// The checkpoints of a run: FOLDER/checkpoint, written anew every so many simulated seconds.
class RunCheckpoints {
 public:
  /// every [s]: none are written without it. t_start [s]: of the scenario.
  RunCheckpoints(Checkpoint checkpoint, std::filesystem::path folder, std::optional<double> every,
                 double t_start);

  const std::filesystem::path& file() const { return file_; }
  bool wanted() const { return every_.has_value(); }
  /// The run stands where `from` was written; time [s] is where that is.
  void resume(const std::filesystem::path& from) { checkpoint_.resume(from); }
  void begin_at(double time) { passed_ = times_passed(time); }
  /// time [s]: how far the run has come.
  bool is_due(double time) const;
  void write_at(double time);
  void write() { checkpoint_.write(file_), has_written_ = true; }
  /// A note if some were wanted and the run ended before the first; else empty.
  std::string note() const;

 private:
  /// Times of checkpoints up to t.
  double times_passed(double t) const;

  Checkpoint checkpoint_;
  std::filesystem::path file_;
  std::optional<double> every_;
  bool has_written_ = false;
  double t_start_, passed_ = 0.0;  ///< passed: times of checkpoints that lie behind
};

}  // namespace tandem::scenario
