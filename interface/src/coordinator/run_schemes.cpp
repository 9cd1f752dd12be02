// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Whether the schedule can honour what is asked for.
#include <algorithm>
#include <cmath>

#include "run_start.hpp"
#include "tandem/error.hpp"

namespace tandem {
namespace {

[[noreturn]] void refuse(const std::string& sentence) { throw Error(ErrorCode::not_supported, sentence); }

std::size_t position(const std::vector<int>& order, int who) {
  return static_cast<std::size_t>(std::find(order.begin(), order.end(), who) - order.begin());
}

}  // namespace

void RunStart::check_schemes(const std::vector<int>& order) const {
  if (run_.coordination_.schedule == Schedule::Kind::staggered && order.size() != 2)
    refuse("schedule staggered couples two subsystems that integrate themselves; there are " +
           std::to_string(order.size()));
  if (run_.coordination_.schedule == Schedule::Kind::staggered && misses_middle(order[1], order[0]))
    run_.notes_.push_back(
        "subsystem '" + topology_.name(order[1]) +
        "' can't shorten a step, so schedule staggered keeps a first order part of the size of its own "
        "step over that of '" +
        topology_.name(order[0]) + "'");
  for (const Line& line : topology_.lines()) {
    check_line(line, order);
    note_empty_means(line);
  }
}

void RunStart::note_empty_means(const Line& line) const {
  if (line.how.kind != Reconstruction::Kind::mean || sampled(line.source) ||
      run_.own_step(line.source) <= run_.own_step(line.reader) + rounding())
    return;
  run_.notes_.push_back("input " + topology_.input_name(line.reader, line.input) +
                        " is the mean over an own step, which is shorter than those of '" +
                        topology_.name(line.source) +
                        "': where none of its samples lies in one, it is the mean of the line through those "
                        "beside it");
}

/// The fast side can't cut a step, and none of its nodes lies in the middle of the slow side's step.
bool RunStart::misses_middle(int fast, int slow) const {
  const double middle = run_.own_step(slow) / 2.0, nearest = std::remainder(middle, run_.own_step(fast));
  const Abilities &a = topology_.info(fast).abilities, &b = topology_.info(slow).abilities;
  return !a.lands && (a.chooses_step || b.chooses_step ||
                      std::abs(nearest) > (1.0 + middle / run_.own_step(fast)) * rounding());
}

void RunStart::check_line(const Line& line, const std::vector<int>& order) const {
  using Kind = Reconstruction::Kind;
  if (sampled(line.source) || sampled(line.reader)) return;
  const Schedule::Kind schedule = run_.coordination_.schedule;
  const std::string what =
      "input " + topology_.input_name(line.reader, line.input) + " is reconstructed by " + line.how.name();
  const bool turns = schedule == Schedule::Kind::slowest_first || schedule == Schedule::Kind::fastest_first;
  if (schedule == Schedule::Kind::staggered && line.how.kind != Kind::matched_hold &&
      line.how.kind != Kind::held)
    refuse(what + "; schedule staggered takes matched_hold only");
  if (schedule == Schedule::Kind::parallel && line.how.kind == Kind::matched_hold)
    refuse(what + ", which needs subsystems that take turns; schedule parallel has none");
  if (line.how.kind == Kind::mean && !(turns && position(order, line.source) < position(order, line.reader)))
    refuse(what + ", which needs a source that is ahead of its reader; in schedule " +
           std::string(Schedule::name(schedule)) + " '" + topology_.name(line.source) +
           "' is not ahead of '" + topology_.name(line.reader) + "'");
  if (line.lag == Lag::memory && topology_.info(line.reader).abilities.chooses_step)
    refuse("input " + topology_.input_name(line.reader, line.input) +
           " has a memory of one own step, but its subsystem chooses its steps; use a delay");
}

}  // namespace tandem
