// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "run_start.hpp"
#include "tandem/error.hpp"

namespace tandem {

bool RunStart::derivatives_suffice() const {
  return std::all_of(topology_.lines().begin(), topology_.lines().end(), [&](const Line& line) {
    return !seeds_needed(line) ||
           scalar_at(topology_.info(line.source).outputs, line.output).port->derivatives >=
               line.how.derivatives_at_start();
  });
}

bool RunStart::can_repeat() const {
  for (int i = 0; i < topology_.size(); ++i)
    if (const Abilities& a = topology_.info(i).abilities; !a.restarts || a.sampled || (a.events && !a.lands))
      return false;
  return std::none_of(topology_.lines().begin(), topology_.lines().end(),
                      [](const Line& line) { return line.how.kind == Reconstruction::Kind::matched_hold; });
}

/// The start that is asked for, or the best that there is. Notes a cold one that costs order.
StartKind RunStart::choose() {
  const auto& lines = topology_.lines();
  const StartKind asked = run_.coordination_.start;
  const std::string needs = "the outputs give too few derivatives for the degrees of their connections";
  const std::string stays =
      "not every subsystem can restart, one is sampled, one with events can't shorten a step, or a "
      "connection is a matched hold";
  if (asked == StartKind::derivatives && !derivatives_suffice())
    throw Error(ErrorCode::not_supported, "start from derivatives: " + needs);
  if (asked == StartKind::repeat && !can_repeat())
    throw Error(ErrorCode::not_supported, "repeated start: " + stays);
  if (asked != StartKind::automatic) return asked;
  if (std::none_of(lines.begin(), lines.end(), [&](const Line& line) { return seeds_needed(line); }))
    return StartKind::cold;
  if (derivatives_suffice()) return StartKind::derivatives;
  if (can_repeat()) return StartKind::repeat;
  note_cold(needs + ", and " + stays);
  return StartKind::cold;
}

void RunStart::note_cold(const std::string& why) const {
  run_.notes_.push_back(
      "cold start: " + why +
      "; the order stays at 2 where inputs are extrapolated, at 3 where they are interpolated");
}

/// Past samples at t_start - k h by Taylor expansion, as many as the widest reader of each source takes.
void RunStart::seed() {
  std::vector<int> counts(run_.own_steps_.size());
  for (const Line& line : topology_.lines())
    if (seeds_needed(line)) {
      int& count = counts[static_cast<std::size_t>(line.source)];
      count = std::max(count, line.how.samples() - 1);
    }
  open_exchange(counts);
}

}  // namespace tandem
