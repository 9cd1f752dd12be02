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

Schedule::Schedule(Kind kind, std::vector<int> order, TimeSpan span, double communication_step)
    : kind_(kind),
      order_(std::move(order)),
      t_start_(span.start),
      t_stop_(span.stop),
      communication_step_(communication_step),
      tolerance_(t_start_),
      earliest_stop_(t_stop_ - tolerance_.width(t_start_, t_stop_)),
      latest_stop_(t_stop_ + tolerance_.width(t_start_, t_stop_)) {
  round_.resize(order_.size());
}

inline void Schedule::add(int who, const Member& m, double limit) {
  const double to = std::max(std::min(limit, t_stop_), m.next);
  round_[count_++] = {who, to, m.lands && to >= earliest_stop_};
}

/// The one with the smallest next node is due; a leader that does not yet stand at or past that node goes
/// before it. A follower goes as far as its leaders stand, a leader as far as its followers' next nodes.
inline void Schedule::take_turns(std::span<const Member> members) {
  const auto at = [&](std::size_t p) -> const Member& {
    return members[static_cast<std::size_t>(order_[p])];
  };
  const std::size_t n = order_.size();
  std::size_t due = 0;
  for (std::size_t p = 1; p < n; ++p)
    if (tolerance_.before(at(p).next, at(due).next)) due = p;
  if (at(due).finished()) return;
  double limit = t_stop_;
  for (std::size_t q = 0; q < due; ++q) {
    limit = std::min(limit, at(q).time);
    if (!tolerance_.before(at(q).time, at(due).next)) continue;
    limit = t_stop_;
    due = std::exchange(q, std::size_t{0} - 1);  // q is due, and its own leaders may have to go before it
  }
  for (std::size_t q = due + 1; q < n; ++q) limit = std::min(limit, at(q).next);
  add(order_[due], at(due), at(due).reads_mean ? at(due).next : limit);
}

void Schedule::set_reads(std::vector<char> reads) {
  const std::size_t n = order_.size();
  linked_.assign(n * n, 0);
  foreseen_.resize(n);
  bool all = true;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      linked_[i * n + j] = i == j || reads[i * n + j] || reads[j * n + i];
      all = all && linked_[i * n + j];
    }
  if (all) linked_.clear();
}

/// It follows all others of the round, and neither reads nor is read by any of them.
bool Schedule::is_free(int who, std::size_t count) const {
  const auto place = std::find(order_.begin(), order_.end(), who);
  for (std::size_t k = 0; k < count; ++k)
    if (std::find(place, order_.end(), round_[k].who) != order_.end() ||
        linked_[static_cast<std::size_t>(who) * order_.size() + static_cast<std::size_t>(round_[k].who)])
      return false;
  return true;
}

/// A turn of one own step, which ends at its limit, leaves its member there; where its next step ends is not
/// known yet, only that it is later. Who is due by then is due in any case.
void Schedule::take_more_turns(std::span<const Member> members) {
  std::copy(members.begin(), members.end(), foreseen_.begin());
  double earliest = t_stop_;
  for (std::size_t count = 1; count_ == count && count < order_.size(); ++count) {
    const Turn last = round_[count - 1];
    Member& m = foreseen_[static_cast<std::size_t>(last.who)];
    if (m.next != last.limit) return;
    earliest = std::min(earliest, last.limit);
    stand(m, last.limit, last.limit + 2.0 * tolerance_.width(last.limit, last.limit));
    take_turns(foreseen_);
    if (count_ == count) return;
    const int next = round_[count].who;
    if (tolerance_.before(earliest, foreseen_[static_cast<std::size_t>(next)].next) || !is_free(next, count))
      count_ = count;
  }
}

/// The slow side steps when the fast side stands in the middle of that step.
void Schedule::stagger(std::span<const Member> members) {
  assert(order_.size() == 2);
  const Member& slow = members[static_cast<std::size_t>(order_[0])];
  const Member& fast = members[static_cast<std::size_t>(order_[1])];
  const double middle = slow.time + (slow.next - slow.time) / 2.0;
  if (!slow.finished() && !fast.finished() && tolerance_.before(fast.time, middle))
    round_[count_++] = {order_[1], fast.lands ? middle : std::max(middle, fast.next), fast.lands};
  else if (!slow.finished())
    add(order_[0], slow, slow.next);
  else if (!fast.finished())
    add(order_[1], fast, t_stop_);
}

void Schedule::all_at_once(std::span<const Member> members) {
  double first = Member::never;
  for (const Member& m : members) first = std::min(first, m.next);
  if (first == Member::never) return;
  double k = std::ceil((first - t_start_) / communication_step_);
  if (!tolerance_.before(t_start_ + (k - 1.0) * communication_step_, first)) k -= 1.0;
  const double target = std::min(t_start_ + k * communication_step_, t_stop_);
  for (std::size_t i = 0; i < members.size(); ++i)
    if (!tolerance_.before(target, members[i].next)) add(static_cast<int>(i), members[i], target);
}

std::span<const Turn> Schedule::next_round(std::span<const Member> members) {
  count_ = 0;
  switch (kind_) {
    case Kind::slowest_first:
    case Kind::fastest_first:
      take_turns(members);
      if (!linked_.empty()) take_more_turns(members);
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

}  // namespace tandem
