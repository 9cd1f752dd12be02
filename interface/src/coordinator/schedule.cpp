// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/schedule.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "tandem/error.hpp"

namespace tandem {
namespace {
constexpr std::array<std::string_view, 4> names = {"slowest-first", "fastest-first", "staggered", "parallel"};

bool any(const std::vector<Member>& members, bool Member::*has) {
  return std::any_of(members.begin(), members.end(), std::mem_fn(has));
}

bool are_linked(std::span<const Read> reads) {
  return std::any_of(reads.begin(), reads.end(), [](const Read& r) { return r.reader != r.source; });
}

std::vector<int> all_in_order(const Schedule::Plan& plan) {
  std::vector<int> all = plan.order;
  all.insert(all.end(), plan.sampled.begin(), plan.sampled.end());
  return all;
}
}  // namespace

Schedule::Kind Schedule::parse(std::string_view text) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == text) return static_cast<Kind>(i);
  throw Error(
      ErrorCode::invalid_argument,
      "schedule '" + std::string(text) + "' is not one of slowest-first, fastest-first, staggered, parallel");
}

std::string_view Schedule::name(Kind kind) { return names[static_cast<std::size_t>(kind)]; }

Schedule::Schedule(Plan plan, std::vector<Member> members, std::span<const Read> reads)
    : plan_(std::move(plan)),
      members_(std::move(members)),
      in_turns_(plan_.kind == Kind::slowest_first || plan_.kind == Kind::fastest_first),
      sampled_(any(members_, &Member::sampled)),
      events_(any(members_, &Member::events)),
      landings_(sampled_ || plan_.has_breaks || (events_ && plan_.kind != Kind::staggered)),
      pair_(in_turns_ && !landings_ && members_.size() == 2 && are_linked(reads)),
      related_((in_turns_ && !pair_) || sampled_),
      tolerance_(plan_.span.start),
      round_(members_.size()) {
  stop_at(plan_.span.stop);
  if (!related_) return;
  const std::vector<int> all = all_in_order(plan_);
  assert(all.size() == members_.size());
  turns_ = TurnOrder(all, relations(all, reads, members_, in_turns_), tolerance_);
}

void Schedule::stop_at(double stop) {
  const double width = tolerance_.width(plan_.span.start, stop);
  plan_.span.stop = stop, earliest_stop_ = stop - width, latest_stop_ = stop + width;
}

double Schedule::find_landing(int who, double time, double break_at) {
  Member& m = members_[static_cast<std::size_t>(who)];
  if (sampled_) break_at = turns_.landing(members_, who, {time, break_at});
  m.landing = m.lands ? break_at : Member::never;
  return m.landing;
}

/// Who lands does so to the last bit where it is to, whatever limit is near there.
inline void Schedule::add(int who, double limit) {
  const Member& m = member(who);
  double to = std::max(std::min(limit, plan_.span.stop), m.next);
  const bool lands = landings_ && m.landing < earliest_stop_ && !tolerance_.before(to, m.landing),
             stops = !lands && to >= earliest_stop_;
  if (lands) to = m.landing;
  round_[count_++] = {who, to, m.lands && (stops || lands)};
}

/// The slow side steps when the fast side stands in the middle of that step. Who waits for a sampled member
/// lets the other one take a step, which that member may wait for.
void Schedule::stagger() {
  assert(plan_.order.size() == 2);
  const int slow = plan_.order[0], fast = plan_.order[1];
  const Member &s = member(slow), &f = member(fast);
  const double middle = s.time + (s.next - s.time) / 2.0;
  const bool to_middle = !s.finished() && !f.finished() && tolerance_.before(f.time, middle);
  int who = to_middle || s.finished() ? fast : slow;
  const bool waits = sampled_ && turns_.waits(who);
  if (waits) who = who == fast ? slow : fast;
  if (member(who).finished()) return;
  if (who == slow || waits) return add(who, member(who).next);
  const double known = sampled_ ? turns_.limit(members_, fast) : Member::never;
  const double to = std::min(to_middle ? middle : plan_.span.stop, known);
  if (to_middle && f.lands)
    round_[count_++] = {fast, to, true};
  else
    add(fast, to);
}

/// The rule of TurnOrder for two that are linked, without what it takes to find them among thousands.
void Schedule::turn_of_pair() {
  const Member &leader = member(plan_.order[0]), &follower = member(plan_.order[1]);
  const bool followers = !tolerance_.before(leader.time, follower.next);
  const Member& m = followers ? follower : leader;
  if (!m.finished())
    add(plan_.order[followers ? 1 : 0], m.one_step ? m.next : followers ? leader.time : follower.next);
}

bool Schedule::add_samples() {
  turns_.each_ready(members_, Member::never, [this](int who, double limit) {
    if (member(who).sampled) add(who, limit);
  });
  return count_ > 0;
}

/// At or past the first node of all that need not wait.
inline double Schedule::communication_point() const {
  double first = Member::never;
  for (std::size_t i = 0; i < members_.size(); ++i)
    if (!related_ || !turns_.waits(static_cast<int>(i))) first = std::min(first, members_[i].next);
  if (first == Member::never || plan_.rounds_end_at.empty()) return communication_point(first);
  const auto jump = std::lower_bound(plan_.rounds_end_at.begin(), plan_.rounds_end_at.end(),
                                     first - tolerance_.width(first, first));
  const double point = communication_point(first);
  return jump == plan_.rounds_end_at.end() ? point : std::min(point, *jump);
}

/// Without known jumps.
inline double Schedule::communication_point(double first) const {
  if (first == Member::never) return first;
  if (plan_.pace >= 0 && !member(plan_.pace).finished() && !(related_ && turns_.waits(plan_.pace)))
    return std::min(member(plan_.pace).next, plan_.span.stop);
  const double from = plan_.pace >= 0 ? pace_node_ : plan_.span.start;
  double k = std::ceil((first - from) / plan_.communication_step);
  if (!tolerance_.before(from + (k - 1.0) * plan_.communication_step, first)) k -= 1.0;
  return std::min(from + k * plan_.communication_step, plan_.span.stop);
}

template <class Takes>
void Schedule::add_those(double target, const Takes& takes) {
  const auto add_one = [&](int who, double limit) {
    if (takes(member(who))) add(who, std::min(limit, target));
  };
  if (related_)
    turns_.each_ready(members_, Member::never, add_one);
  else
    for (std::size_t i = 0; i < members_.size(); ++i)
      if (!members_[i].finished()) add_one(static_cast<int>(i), members_[i].landing);
}

/// Those with events stand at the communication point or past it before the others go there, which then know
/// of their events.
inline void Schedule::add_up_to(double target) {
  if (target == Member::never) return;
  const auto reaches = [&](const Member& m) { return !tolerance_.before(target, m.next); };
  if (events_)
    add_those(target, [&](const Member& m) {
      return m.events ? tolerance_.before(m.time, target) : m.sampled && reaches(m);
    });
  if (count_ == 0) add_those(target, reaches);
}

std::span<const Turn> Schedule::next_round() {
  count_ = 0;
  if (pair_)
    turn_of_pair();
  else if (in_turns_)
    turns_.each_turn(members_, plan_.communication_step, [this](int who, double limit) { add(who, limit); });
  else if (plan_.kind == Kind::parallel)
    add_up_to(target_ = communication_point());
  else if (!related_ || !add_samples())
    stagger();
  return {round_.data(), count_};
}

std::span<const Turn> Schedule::rest_of_round() {
  count_ = 0;
  if (plan_.kind == Kind::parallel && landings_) add_up_to(target_);
  return {round_.data(), count_};
}

}  // namespace tandem
