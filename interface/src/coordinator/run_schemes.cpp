// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Whether the schedule can honour what is asked for.
#include <cmath>

#include "reconstruction_rules.hpp"
#include "run_start.hpp"
#include "tandem/error.hpp"

namespace tandem {
namespace {

[[noreturn]] void refuse(const std::string& sentence) { throw Error(ErrorCode::not_supported, sentence); }

/// By subsystem its place in the order.
std::vector<std::size_t> places(const std::vector<int>& order, int subsystems) {
  std::vector<std::size_t> all(static_cast<std::size_t>(subsystems), order.size());
  for (std::size_t k = 0; k < order.size(); ++k) all[static_cast<std::size_t>(order[k])] = k;
  return all;
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
  const auto place = places(order, topology_.size());
  for (const Line& line : topology_.lines()) {
    const bool integrate = !sampled(line.source) && !sampled(line.reader);
    if (integrate)
      check_in_schedule(topology_, line, run_.coordination_.schedule,
                        place[line.source] < place[line.reader]);
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

}  // namespace tandem
