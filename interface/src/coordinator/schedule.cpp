// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/schedule.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <string>
#include <utility>

#include "tandem/error.hpp"

namespace tandem {
namespace {
constexpr std::array<std::string_view, 4> names = {"slowest-first", "fastest-first", "staggered", "parallel"};
}

Schedule::Kind Schedule::parse(std::string_view text) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == text) return static_cast<Kind>(i);
  throw Error(
      ErrorCode::invalid_argument,
      "schedule '" + std::string(text) + "' is not one of slowest-first, fastest-first, staggered, parallel");
}

std::string_view Schedule::name(Kind kind) { return names[static_cast<std::size_t>(kind)]; }

Schedule::Schedule(Kind kind, std::vector<Member> members, std::vector<int> order,
                   std::span<const Read> reads, TimeSpan span, double communication_step)
    : kind_(kind),
      in_turns_(kind == Kind::slowest_first || kind == Kind::fastest_first),
      members_(std::move(members)),
      t_start_(span.start),
      t_stop_(span.stop),
      communication_step_(communication_step),
      tolerance_(t_start_),
      earliest_stop_(t_stop_ - tolerance_.width(t_start_, t_stop_)),
      latest_stop_(t_stop_ + tolerance_.width(t_start_, t_stop_)),
      turns_(std::move(order), reads, tolerance_),
      round_(members_.size()) {}

inline void Schedule::add(int who, double limit) {
  const Member& m = member(who);
  const double to = std::max(std::min(limit, t_stop_), m.next);
  round_[count_++] = {who, to, m.lands && to >= earliest_stop_};
}

/// The slow side steps when the fast side stands in the middle of that step.
void Schedule::stagger() {
  assert(order().size() == 2);
  const Member &slow = member(order()[0]), &fast = member(order()[1]);
  const double middle = slow.time + (slow.next - slow.time) / 2.0;
  if (!slow.finished() && !fast.finished() && tolerance_.before(fast.time, middle))
    round_[count_++] = {order()[1], fast.lands ? middle : std::max(middle, fast.next), fast.lands};
  else if (!slow.finished())
    add(order()[0], slow.next);
  else if (!fast.finished())
    add(order()[1], t_stop_);
}

void Schedule::all_at_once() {
  double first = Member::never;
  for (const Member& m : members_) first = std::min(first, m.next);
  if (first == Member::never) return;
  double k = std::ceil((first - t_start_) / communication_step_);
  if (!tolerance_.before(t_start_ + (k - 1.0) * communication_step_, first)) k -= 1.0;
  const double target = std::min(t_start_ + k * communication_step_, t_stop_);
  for (std::size_t i = 0; i < members_.size(); ++i)
    if (!tolerance_.before(target, members_[i].next)) add(static_cast<int>(i), target);
}

std::span<const Turn> Schedule::next_round() {
  count_ = 0;
  if (in_turns_)
    turns_.each_turn(members_, communication_step_, [this](int who, double limit) { add(who, limit); });
  else if (kind_ == Kind::staggered)
    stagger();
  else
    all_at_once();
  return {round_.data(), count_};
}

}  // namespace tandem
