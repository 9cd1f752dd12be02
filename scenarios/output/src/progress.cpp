// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/output/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace tandem::output {
namespace {
using Clock = std::chrono::steady_clock;
double seconds(Clock::duration d) { return std::chrono::duration<double>(d).count(); }
}  // namespace

void show_progress(const std::string& text) {
  static_cast<void>(std::fputs(text.c_str(), stderr));
  static_cast<void>(std::fflush(stderr));
}

Progress::Progress(std::string what, std::size_t total, bool shown)
    : what_(std::move(what)), total_(total), shown_(shown), terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (open_line_) show_progress("\n");
}

void Progress::update(std::size_t done) {
  if (!shown_) return;
  const auto now = Clock::now();
  if (!begun_) {
    begun_ = true;
    started_ = now;
    drawn_ = now - std::chrono::hours(1);
    first_done_ = done;
  }
  if (done < total_ && seconds(now - drawn_) < (terminal_ ? 0.1 : 5.0)) return;
  drawn_ = now;
  draw(done);
}

void Progress::draw(std::size_t done) {
  const double share = static_cast<double>(done) / static_cast<double>(total_);
  const double spent = seconds(drawn_ - started_);
  const auto here = static_cast<double>(done - first_done_);
  std::string left = done == total_ ? fmt::format("{:.1f} s", spent) : std::string("estimating");
  if (done < total_ && here > 0.0)
    left = fmt::format("about {:.0f} s left", spent / here * static_cast<double>(total_ - done));
  const auto filled = static_cast<std::size_t>(30.0 * share);
  const std::string line = fmt::format("tandem: {} [{}{}] {}/{}  {}", what_, std::string(filled, '#'),
                                       std::string(30 - filled, '.'), done, total_, left);
  show_progress(fmt::format("{}{}{}", terminal_ ? "\r" : "", line, terminal_ ? "   " : "\n"));
  open_line_ = terminal_;
}

}  // namespace tandem::output
