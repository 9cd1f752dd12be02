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

Schedule::Schedule(Kind kind, std::vector<int> order, double t_start, double t_stop,
                   double communication_step)
    : kind_(kind),
      order_(std::move(order)),
      t_start_(t_start),
      t_stop_(t_stop),
      communication_step_(communication_step),
      tolerance_(t_start),
      earliest_stop_(t_stop - tolerance_.width(t_start, t_stop)),
      latest_stop_(t_stop + tolerance_.width(t_start, t_stop)) {
  round_.resize(order_.size());
}

std::span<const Turn> Schedule::next_round(std::span<const Member> members) {
  count_ = 0;
  switch (kind_) {
    case Kind::slowest_first:
    case Kind::fastest_first:
      take_turns(members);
      break;
    case Kind::staggered:
      stagger(members);
      break;
    case Kind::parallel:
      all_at_once(members);
      break;
  }
  return {round_.data(), count_};
}

void Schedule::add(int who, const Member& m, double limit) {
  const double to = std::min(std::max(limit, m.next), t_stop_);
  round_[count_++] = {who, to, m.lands && to >= earliest_stop_};
}

/// The one with the smallest next node is due; a leader that does not yet stand at or past that node goes
/// before it.
void Schedule::take_turns(std::span<const Member> members) {
  const Member* due = nullptr;
  std::size_t position = 0;
  for (std::size_t p = 0; p < order_.size(); ++p) {
    const Member& m = members[static_cast<std::size_t>(order_[p])];
    if (finished(m) || (due && !tolerance_.before(m.next, due->next))) continue;
    due = &m;
    position = p;
  }
  if (!due) return;
  for (std::size_t q = 0; q < position;) {
    const Member& leader = members[static_cast<std::size_t>(order_[q])];
    const bool behind = !finished(leader) && tolerance_.before(leader.time, due->next);
    if (behind) due = &leader, position = q;
    q = behind ? 0 : q + 1;  // its own leaders may have to go before it
  }
  add(order_[position], *due, due->reads_mean ? due->next : limit_of(members, position));
}

/// A follower goes as far as its leaders stand; a leader as far as its followers' next nodes.
double Schedule::limit_of(std::span<const Member> members, std::size_t position) const {
  double limit = t_stop_;
  for (std::size_t q = 0; q < order_.size(); ++q) {
    const Member& other = members[static_cast<std::size_t>(order_[q])];
    if (q != position && !finished(other)) limit = std::min(limit, q < position ? other.time : other.next);
  }
  return limit;
}

/// The slow side steps when the fast side stands in the middle of that step.
void Schedule::stagger(std::span<const Member> members) {
  assert(order_.size() == 2);
  const Member& slow = members[static_cast<std::size_t>(order_[0])];
  const Member& fast = members[static_cast<std::size_t>(order_[1])];
  const double middle = slow.time + (slow.next - slow.time) / 2.0;
  if (!finished(slow) && !finished(fast) && tolerance_.before(fast.time, middle))
    round_[count_++] = {order_[1], fast.lands ? middle : std::max(middle, fast.next), fast.lands};
  else if (!finished(slow))
    add(order_[0], slow, slow.next);
  else if (!finished(fast))
    add(order_[1], fast, t_stop_);
}

void Schedule::all_at_once(std::span<const Member> members) {
  double first = t_stop_;
  bool any = false;
  for (const Member& m : members)
    if (!finished(m)) first = std::min(first, m.next), any = true;
  if (!any) return;
  double k = std::ceil((first - t_start_) / communication_step_);
  if (!tolerance_.before(t_start_ + (k - 1.0) * communication_step_, first)) k -= 1.0;
  const double target = std::min(t_start_ + k * communication_step_, t_stop_);
  for (std::size_t i = 0; i < members.size(); ++i)
    if (!finished(members[i]) && !tolerance_.before(target, members[i].next))
      add(static_cast<int>(i), members[i], std::max(target, members[i].next));
}

}  // namespace tandem
