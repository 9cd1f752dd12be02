// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "run_checkpoints.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "tandem/error.hpp"

namespace tandem::scenario {

RunCheckpoints::RunCheckpoints(Checkpoint checkpoint, std::filesystem::path folder,
                               std::optional<double> every, double t_start)
    : checkpoint_(std::move(checkpoint)),
      file_(std::move(folder) / "checkpoint"),
      every_(every),
      t_start_(t_start) {
  if (every_ && !(*every_ > 0.0 && std::isfinite(*every_)))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("--checkpoint-every is {} s; allowed is a number above 0", *every_));
}

double RunCheckpoints::times_passed(double t) const {
  return every_ ? std::floor((t - t_start_) / *every_) : 0.0;
}

bool RunCheckpoints::is_due(double time) const { return times_passed(time) > passed_; }

void RunCheckpoints::write_at(double time) {
  write();
  passed_ = times_passed(time);
}

std::string RunCheckpoints::note() const {
  if (!every_ || has_written_) return "";
  return fmt::format("no checkpoint was written: the run ended before the first, {} s after its start{}",
                     *every_,
                     std::filesystem::exists(file_) ? "; " + file_.string() + " is an earlier run's" : "");
}

}  // namespace tandem::scenario
