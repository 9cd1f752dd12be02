// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/coordinator.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "../number_text.hpp"
#include "../seconds_now.hpp"
#include "named.hpp"
#include "run_start.hpp"
#include "tandem/error.hpp"

namespace tandem {
std::string_view name(StartKind start) {
  constexpr std::string_view names[] = {"automatic", "derivatives", "repeat", "cold"};
  return names[static_cast<std::size_t>(start)];
}

/// Rows from `row` on that are the second ones of their times, and no step's.
static std::int64_t jumps_in(const Samples& y, std::int64_t row) {
  std::int64_t count = 0;
  while (row < y.size()) count += y.jump(row++) ? 1 : 0;
  return count;
}

Coordinator::Coordinator(const Topology& topology, const std::vector<Subsystem*>& subsystems,
                         Coordination coordination, TimeSpan span)
    : topology_(topology),
      coordination_(std::move(coordination)),
      t_start_(span.start),
      t_stop_(span.stop),
      tolerance_(span.start) {
  assert(static_cast<int>(subsystems.size()) == topology.size());
  if (!std::isfinite(t_start_) || !std::isfinite(t_stop_) || !tolerance_.before(t_start_, t_stop_))
    throw Error(ErrorCode::invalid_argument, "the span from " + number_text(t_start_) + " s to " +
                                                 number_text(t_stop_) + " s does not end after its start");
  for (Subsystem* subsystem : subsystems) seats_.push_back({subsystem});
  own_next_.resize(seats_.size());
  event_seats_.resize(seats_.size());
  not_known_here_ = topology_.size();
  begin_threads();
}

void Coordinator::initialize() {
  Observer* observer = std::exchange(observer_, nullptr);  // is told once, when the start is made
  RunStart(*this).make();
  observer_ = observer;
  for (int i = 0; i < topology_.size(); ++i) {
    seats_[static_cast<std::size_t>(i)].told = exchange_->history(i).first_own() - 1;
    tell(i);
  }
}

void Coordinator::run() {
  initialize();
  while (round())
    if (observer_) observer_->between_rounds();
}

bool Coordinator::round() {
  if (stopped_) return false;
  return make_round() ? !stopped_ : end();
}

/// False: there was none left.
bool Coordinator::make_round() {
  const auto turns = schedule_->next_round();
  if (turns.empty()) return false;
  try {
    has_samples_ || frozen_ ? make_in_parts(turns) : make(turns);
  } catch (...) {
    const std::span<const Turn> under_way = has_samples_ || frozen_ ? going_ : turns;
    finish_all(under_way);
    for (const Turn& turn : under_way) keep(turn);
    keep_rest();
    throw;
  }
  return true;
}

/// Before a call: a state to go back to, if it may, and room for its rows. What stays by now is told, as rows
/// from before the oldest state are dropped.
inline void Coordinator::make_ready(int who) {
  const Seat& seat = this->seat(who);
  if (seat.goes_back) tell(who), remember(who);
  if (!exchange_->history(who).has_room(seat.batch)) exchange_->make_room(who, seat.batch);
}

/// Its inputs, from where it stands.
inline void Coordinator::read(const Turn& turn, Exchange& inputs) {
  Seat& seat = this->seat(turn.who);
  seat.u = inputs.inputs(turn.who, seat.time, schedule_->member(turn.who).next, turn.limit);
  seat.rows = exchange_->history(turn.who).room().size();
  seat.call = Seat::Call::prepared;
}

/// The subsystem's call, or the second half of one that has begun; its error names it.
inline Clock Coordinator::advance(const Turn& turn, Samples& y) {
  Seat& seat = this->seat(turn.who);
  const Seat::Call call = std::exchange(seat.call, Seat::Call::failed);
  const bool timed = call != Seat::Call::offered && is_timed(turn.who);
  const double begin = timed ? seconds_now() : 0.0;
  const Clock clock = named_advance(topology_.name(turn.who), seat.time, turn.limit, [&] {
    if (call == Seat::Call::offered) return finish_offered(turn.who);
    if (call == Seat::Call::under_way) return seat.subsystem->finish_advance(y);
    return seat.subsystem->advance(turn.limit, turn.land, seat.u, y);
  });
  if (timed) note_seconds(turn.who, seconds_now() - begin);
  return clock;
}

/// In parallel with sampled subsystems or events the others see it when the round is over.
inline void Coordinator::commit(int who, double limit) {
  const std::int64_t count = frozen_ ? exchange_->accept(who, limit) : exchange_->commit(who, limit);
  if (count == 0) return;
  tell(who);
  if (has_events_ && schedule_->member(who).events) hear_of_event(who);
  if (lands_elsewhere_ && !frozen_ && schedule_->member(who).jumps) hear_of_jump(who);
}

/// A second row may be a jump for those that read it, too.
void Coordinator::hear_of_jump(int who) {
  const History& history = exchange_->history(who);
  if (history.jump(history.newest())) place_readers(who);
}

/// A call that ends where it begins.
void Coordinator::tell_jump(int who) {
  const Turn turn{who, time(who), false};
  take(turn, *exchange_);
  commit(who, turn.limit);
  if (frozen_) exchange_->publish(who);
}

void Coordinator::make(std::span<const Turn> turns) {
  if (!through_.empty()) await_jumps(turns);
  if (turns.size() > 1 || schedule_->kind() == Schedule::Kind::parallel) return make_together(turns);
  if (!seat(turns[0].who).works_here) make_ready(turns[0].who), start(turns[0]);  // it may work elsewhere
  take(turns[0], *exchange_);
  commit(turns[0].who, turns[0].limit);
}

/// None of them reads what another gives in this round. All are made, also after an error, so that it is the
/// same one, with the same samples kept, whoever makes them. One after the other, if nobody works elsewhere:
/// what one goes by is at hand once, then.
void Coordinator::make_together(std::span<const Turn> turns) {
  const bool alone = not_known_here_ == 0 && !is_work_for_threads(turns);
  const bool parallel = schedule_->kind() == Schedule::Kind::parallel;
  FirstError error;
  if (!alone) work_at_once(turns, error);
  const auto each = [&](const auto& work) {
    for (std::size_t k = 0; k < turns.size(); ++k)
      if (seat(turns[k].who).call != Seat::Call::failed) error.of(k, [&] { work(turns[k]); });
  };
  each([&](const Turn& turn) {
    if (alone) take(next_call(turn), *exchange_);
    parallel ? go_on(turn) : commit(turn.who, turn.limit);
  });
  if (parallel) each([&](const Turn& turn) { commit(turn.who, turn.limit); });
  error.raise();
}

/// The first call of each. All that can be are set to work before the first is waited for; the others work
/// meanwhile. Memory moves before the inputs are there.
void Coordinator::work_at_once(std::span<const Turn> turns, FirstError& error) {
  const auto elsewhere = [this](const Turn& turn) { return seat(turn.who).call > Seat::Call::prepared; };
  for (const Turn& turn : turns) make_ready(turn.who);
  for (const Turn& turn : turns) start(turn);
  for (const bool waits : {false, true})
    for (std::size_t k = 0; k < turns.size(); ++k)
      if (elsewhere(turns[k]) == waits && seat(turns[k].who).call > Seat::Call::failed)
        error.of(k, [&] { take(next_call(turns[k]), *exchange_); });
}

/// After an error: what the others are at work on is awaited, for their samples. The error is the one to be
/// heard of.
void Coordinator::finish_all(std::span<const Turn> turns) {
  for (const Turn& turn : turns)
    if (seat(turn.who).call > Seat::Call::prepared) try {
        advance(turn, exchange_->history(turn.who).room());
      } catch (const std::exception&) {
      }
}

/// Tells what a subsystem gave before an error, as far as it is sound. The error is the one to be heard of,
/// not what may follow from it.
void Coordinator::keep(const Turn& turn) {
  if (observer_) try {
      exchange_->history(turn.who).commit(turn.limit, tolerance_);
    } catch (const Error&) {
    }
  if (observer_) try {
      tell(turn.who);
    } catch (const Error&) {
    }
}

/// A node that lies beside the point of communication by rounding is the limit itself, for subsystems that
/// compare strictly. Where it is to land there may have become known on the way.
Turn Coordinator::next_call(const Turn& turn) const {
  if (schedule_->kind() != Schedule::Kind::parallel) return turn;
  const Member& member = schedule_->member(turn.who);
  if (!turn.land && !tolerance_.before(turn.limit, member.landing)) return {turn.who, member.landing, true};
  return {turn.who, std::max(turn.limit, member.next), turn.land};
}

void Coordinator::start(const Turn& turn) {
  Seat& seat = this->seat(turn.who);
  const Turn first = next_call(turn);
  read(first, *exchange_);
  const bool under_way = named_advance(topology_.name(turn.who), seat.time, first.limit, [&] {
    return seat.subsystem->start_advance(first.limit, first.land, seat.u,
                                         exchange_->history(turn.who).room());
  });
  if (under_way)
    seat.call = Seat::Call::under_way;
  else if (threads_)
    offer(first);
  if (!under_way && !std::exchange(seat.works_here, true)) --not_known_here_;
}

/// In parallel: as many calls as it takes to come past the communication point, or to an event.
void Coordinator::go_on(const Turn& turn) {
  const Member& member = schedule_->member(turn.who);
  const Seat& seat = this->seat(turn.who);
  while (!(member.events && seat.stop == Stop::event) && !tolerance_.before(turn.limit, member.next))
    take(next_call(turn), *exchange_);
}

/// One call, on the signals of `inputs`; or the end of the one that has begun.
void Coordinator::take(const Turn& turn, Exchange& inputs) {
  const int who = turn.who;
  Seat& seat = this->seat(who);
  if (seat.call == Seat::Call::none) make_ready(who), read(turn, inputs);
  Samples& y = exchange_->history(who).room();
  const double before = seat.time;
  const Clock clock = advance(turn, y);
  const std::int64_t steps = y.size() - seat.rows;
  seat.effort.exchanges += 1;
  seat.effort.steps += lands_elsewhere_ ? steps - jumps_in(y, seat.rows) : steps;
  if (steps > 0 && clock.time == y.time(y.size() - 1) && clock.time > before && clock.time <= turn.limit &&
      clock.next_time > clock.time)
    seat.idle_calls = 0;
  else
    check_clock(turn, before, steps, clock);
  if (observer_) observer_->inputs(who, {before, clock.time}, inputs.lanes(who));
  seat.stop = clock.stop;
  seat.call = Seat::Call::none;
  stand(who, clock);
}

/// The observer, if there is one, once of each row.
void Coordinator::tell(int who) {
  const History& history = exchange_->history(who);
  Seat& seat = this->seat(who);
  const std::int64_t last = seat.goes_back ? std::max(last_final(who), seat.told) : history.newest(),
                     first = std::exchange(seat.told, last) + 1;
  if (observer_ && first <= last && !observer_->samples(who, history, first, last)) stopped_ = true;
}

/// What is not plain may still be right: no step taken, an end within the tolerance, no further step. Throws
/// otherwise.
void Coordinator::check_clock(const Turn& turn, double before, std::int64_t rows, const Clock& after) {
  const auto [who, limit, land] = turn;
  const Samples& y = exchange_->history(who).room();
  const double stands = rows > 0 ? y.time(y.size() - 1) : before;
  const auto fail = [&](const std::string& what) {
    throw Error(ErrorCode::numerical, advance_of(topology_.name(turn.who), before, turn.limit) + ": " + what);
  };
  if (rows < 0 || !(after.time == stands))
    fail("it says that it stands at t = " + number_text(after.time) + " s, but its newest sample is of " +
         number_text(stands) + " s");
  if (tolerance_.before(limit, after.time))
    fail("it stands at t = " + number_text(after.time) + " s, past its limit " + number_text(limit) + " s");
  if (after.stop != Stop::finished && !(after.next_time > after.time))
    fail("at t = " + number_text(after.time) + " s it gives " + number_text(after.next_time) +
         " s as the end of its next own step, which is not later");
  int& idle_calls = seats_[static_cast<std::size_t>(who)].idle_calls;
  idle_calls = after.time > before ? 0 : idle_calls + 1;
  if (idle_calls >= most_idle_calls)
    fail("it has not moved from t = " + number_text(after.time) + " s in " + std::to_string(most_idle_calls) +
         (after.stop == Stop::event
              ? " calls, each of which had an event: who switches what it reads is switched back, without "
                "end; memory = true on one of their connections breaks the ring"
              : " calls"));
}

}  // namespace tandem
