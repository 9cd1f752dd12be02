// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/coordinator.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "run_start.hpp"
#include "tandem/error.hpp"

namespace tandem {
namespace {

constexpr int most_idle_calls = 100;

[[noreturn]] void fail(const std::string& name, const std::string& what) {
  throw Error(ErrorCode::numerical, "subsystem '" + name + "' " + what);
}

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Coordinator::Coordinator(const Topology& topology, std::vector<Subsystem*> subsystems,
                         Coordination coordination, double t_start, double t_stop)
    : topology_(topology),
      subsystems_(std::move(subsystems)),
      coordination_(std::move(coordination)),
      t_start_(t_start),
      t_stop_(t_stop),
      tolerance_(t_start),
      efforts_(subsystems_.size()),
      idle_calls_(subsystems_.size()) {
  if (!std::isfinite(t_start) || !std::isfinite(t_stop) || !tolerance_.before(t_start, t_stop))
    throw Error(ErrorCode::invalid_argument, "the span from " + std::to_string(t_start) + " s to " +
                                                 std::to_string(t_stop) + " s does not end after its start");
}

void Coordinator::initialize() {
  Observer* observer = std::exchange(observer_, nullptr);  // is told once, when the start is made
  RunStart(*this).make();
  observer_ = observer;
  for (int i = 0; i < topology_.size(); ++i) tell(i, exchange_->history(i).first_own());
}

void Coordinator::run() {
  initialize();
  while (round()) {
  }
}

bool Coordinator::round() {
  if (stopped_) return false;
  const auto turns = schedule_->next_round(members_);
  if (turns.empty()) {
    note_ends();
    stopped_ = true;
    return false;
  }
  if (schedule_->kind() == Schedule::Kind::parallel)
    for (const Turn& turn : turns) take_all(turn);
  else
    advance(turns[0].who, turns[0].limit, turns[0].land);
  for (const Turn& turn : turns) commit(turn.who, turn.limit);
  return !stopped_;
}

/// In parallel: as many calls as it takes to come past the communication point.
void Coordinator::take_all(const Turn& turn) {
  const Member& member = members_[static_cast<std::size_t>(turn.who)];
  do advance(turn.who, turn.limit, turn.land);
  while (!schedule_->finished(member) && !tolerance_.before(turn.limit, member.next));
}

void Coordinator::advance(int who, double limit, bool land) {
  const auto i = static_cast<std::size_t>(who);
  if (!exchange_->history(who).has_room(batches_[i])) exchange_->make_room(who, batches_[i], clocks_);
  call(who, limit, land, exchange_->inputs(who, members_[i].time, members_[i].next));
}

void Coordinator::call(int who, double limit, bool land, std::span<const Signal> u) {
  const auto i = static_cast<std::size_t>(who);
  Samples& y = exchange_->history(who).room();
  const std::int64_t rows = y.size();
  const double started = coordination_.profile ? seconds_now() : 0.0;
  const Clock clock = subsystems_[i]->advance(limit, land, u, y);
  Effort& effort = efforts_[i];
  if (coordination_.profile) effort.seconds += seconds_now() - started;
  ++effort.exchanges;
  effort.steps += y.size() - rows;
  const double before = clocks_[i].time;
  clocks_[i].time = clock.time;  // field by field: a copy of the whole waits for all of it to be stored
  clocks_[i].next_time = clock.next_time;
  clocks_[i].stop = clock.stop;
  const bool plain = y.size() > rows && clock.time == y.time(y.size() - 1) && clock.time > before &&
                     clock.time <= limit && clock.next_time > clock.time;
  idle_calls_[i] = plain ? 0 : idle_calls_[i];
  if (!plain) check_clock(who, before, y.size() - rows, limit);
  update_member(who);
}

void Coordinator::commit(int who, double limit) {
  const std::int64_t first = exchange_->history(who).newest() + 1;
  exchange_->commit(who, limit);
  tell(who, first);
}

void Coordinator::tell(int who, std::int64_t first) {
  const History& history = exchange_->history(who);
  if (observer_ && history.newest() >= first && !observer_->samples(who, history, first, history.newest()))
    stopped_ = true;
}

/// What is not plain may still be right: no step taken, an end within the tolerance, no further step. Throws
/// otherwise.
void Coordinator::check_clock(int who, double before, std::int64_t rows, double limit) {
  const auto i = static_cast<std::size_t>(who);
  const Clock& after = clocks_[i];
  const Samples& y = exchange_->history(who).room();
  const double stands = rows > 0 ? y.time(y.size() - 1) : before;
  if (rows < 0 || !(after.time == stands))
    fail(topology_.name(who), "says that it stands at t = " + std::to_string(after.time) +
                                  " s, but its newest sample is of " + std::to_string(stands) + " s");
  if (tolerance_.before(limit, after.time))
    fail(topology_.name(who), "stands at t = " + std::to_string(after.time) + " s, past its limit " +
                                  std::to_string(limit) + " s");
  if (after.stop != Stop::finished && !(after.next_time > after.time))
    fail(topology_.name(who), "at t = " + std::to_string(after.time) + " s gives " +
                                  std::to_string(after.next_time) +
                                  " s as the end of its next own step, which is not later");
  idle_calls_[i] = after.time > before ? 0 : idle_calls_[i] + 1;
  if (idle_calls_[i] >= most_idle_calls)
    fail(topology_.name(who), "has not moved from t = " + std::to_string(after.time) + " s in " +
                                  std::to_string(most_idle_calls) + " calls");
}

void Coordinator::update_member(int who) {
  const auto i = static_cast<std::size_t>(who);
  const Clock& clock = clocks_[i];
  members_[i].time = clock.time;
  members_[i].next = clock.stop == Stop::finished ? std::numeric_limits<double>::infinity()
                     : members_[i].lands          ? std::min(clock.next_time, t_stop_)
                                                  : clock.next_time;
}

void Coordinator::note_ends() {
  for (int i = 0; i < topology_.size(); ++i)
    if (tolerance_.before(clock(i).time, t_stop_))
      notes_.push_back("subsystem '" + topology_.name(i) + "' ended at t = " + std::to_string(clock(i).time) +
                       " s, its last own node, " + std::to_string(t_stop_ - clock(i).time) +
                       " s before the end");
}

}  // namespace tandem
