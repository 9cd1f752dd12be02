// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/run_progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "cli/say.hpp"

namespace tandem::cli {
namespace {
using Clock = std::chrono::steady_clock;
double seconds_between(Clock::time_point a, Clock::time_point b) {
  return std::chrono::duration<double>(b - a).count();
}
constexpr double quiet_at_first = 1.0;  // [s]
}  // namespace

RunProgress::RunProgress(double t_start, double t_stop, bool shown)
    : t_start_(t_start),
      t_stop_(t_stop),
      shown_(shown),
      terminal_(isatty(STDERR_FILENO) != 0),
      began_(Clock::now()),
      drawn_(began_) {}

RunProgress::~RunProgress() {
  if (open_line_) output::show_progress("\n");
}

void RunProgress::show(double time) {
  const Time now = Clock::now();
  if (!shown_ || seconds_between(drawn_, now) < (terminal_ ? quiet_at_first : 10.0 * quiet_at_first)) return;
  drawn_ = now;
  const double factor = (time - t_start_) / seconds_between(began_, now);
  output::show_progress(fmt::format("{}tandem: t = {:.6g} of {:.6g} s, {:.3g} x real time{}",
                                    terminal_ ? "\r" : "", time, t_stop_, factor, terminal_ ? "   " : "\n"));
  open_line_ = terminal_;
}

void RunProgress::end(double time, double elapsed) {
  if (!shown_) return;
  const double simulated = time - t_start_;
  output::show_progress(fmt::format("{}tandem: {:.6g} s simulated in {:.3g} s, {:.3g} x real time{}\n",
                                    open_line_ ? "\r" : "", simulated, elapsed, simulated / elapsed,
                                    open_line_ ? "          " : ""));
  open_line_ = false;
}

}  // namespace tandem::cli
