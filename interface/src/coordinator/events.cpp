// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Events: what is known of them, and who goes back to one that it has passed.
#include <algorithm>

#include "../number_text.hpp"
#include "named.hpp"
#include "tandem/coordinator/coordinator.hpp"

namespace tandem {

/// The newest row of one with events is a jump: its readers are to end a step there, and those that have
/// passed it go back, or err.
void Coordinator::hear_of_event(int who) {
  const History& history = exchange_->history(who);
  const Seat& seat = seats_[static_cast<std::size_t>(who)];
  for (const int leader : seat.leaders_back) tell(leader);
  if (!history.jump(history.newest())) return;
  const double t = history.time(history.newest());
  if (schedule_->kind() == Schedule::Kind::parallel) schedule_->end_round_at(t);
  for (const int reader : seat.readers)
    if (tolerance_.before(t, time(reader))) pass_by(reader, who, t);
  exchange_->note_jump(who);
  for (const int reader : seat.readers) place(reader);
}

/// `reader` stands past an event of `who` at t.
void Coordinator::pass_by(int reader, int who, double t) {
  const double jump = exchange_->jump(who, reader);
  Seat& seat = seats_[static_cast<std::size_t>(reader)];
  if (jump == 0.0) return;
  if (!seat.back.empty()) return go_back(reader, t);
  Missed& missed = seats_[static_cast<std::size_t>(who)].missed;
  const double size = jump * (time(reader) - t);
  missed.count += 1;
  if (size >= missed.largest) missed.largest = size, missed.reader = reader;
}

/// Before an own step of one that may go back: its state, and no longer those from before where all stand
/// that it may go back for.
void Coordinator::remember(int who) {
  Seat& seat = seats_[static_cast<std::size_t>(who)];
  const double earliest = earliest_event(who);
  while (seat.back.size() > 1 && !tolerance_.before(earliest, seat.back[1].time)) {
    seat.subsystem->release_state(seat.back.front().state);
    seat.back.erase(seat.back.begin());
  }
  const StateId state = named(topology_.name(who), [&] { return seat.subsystem->save_state(); });
  seat.back.push_back({state, seat.time, exchange_->history(who).newest()});
  exchange_->keep_from(who, seat.back.front().time);
}

/// No event comes before this time [s] that it leads.
double Coordinator::earliest_event(int who) const {
  double earliest = Member::never;
  for (const int other : seats_[static_cast<std::size_t>(who)].events_behind)
    earliest = std::min(earliest, time(other));
  return earliest;
}

/// To its last own node at or before t; what it gave after that is taken back.
void Coordinator::go_back(int who, double t) {
  Seat& seat = seats_[static_cast<std::size_t>(who)];
  while (seat.back.size() > 1 && tolerance_.before(t, seat.back.back().time)) {
    seat.subsystem->release_state(seat.back.back().state);
    seat.back.pop_back();
  }
  const Back to = seat.back.back();
  exchange_->withdraw(who, exchange_->history(who).newest() - to.row);
  const Clock clock = named(topology_.name(who), [&] { return seat.subsystem->restore_state(to.state); });
  if (clock.time != to.time)
    throw Error(ErrorCode::numerical,
                "subsystem '" + topology_.name(who) + "' was saved at t = " + number_text(to.time) +
                    " s and says that it stands at t = " + number_text(clock.time) + " s when restored");
  seat.subsystem->release_state(to.state);
  seat.back.pop_back();
  seat.times_back += 1;
  exchange_->rebuild(who);
  stand(who, clock);
}

/// The last row that is not taken back any more.
std::int64_t Coordinator::last_final(int who) const {
  const History& history = exchange_->history(who);
  std::int64_t last = history.newest();
  if (seats_[static_cast<std::size_t>(who)].events_behind.empty() || ended_) return last;
  const double earliest = earliest_event(who);
  while (last >= history.oldest() && tolerance_.before(earliest, history.time(last))) --last;
  return last;
}

void Coordinator::note_events() {
  for (int i = 0; i < topology_.size(); ++i) {
    const Seat& seat = seats_[static_cast<std::size_t>(i)];
    if (seat.times_back > 0)
      notes_.push_back("subsystem '" + topology_.name(i) + "' went back " + std::to_string(seat.times_back) +
                       " times to events that it had passed");
    if (seat.missed.count > 0)
      notes_.push_back("subsystem '" + topology_.name(seat.missed.reader) + "' had passed events of '" +
                       topology_.name(i) + "', " + std::to_string(seat.missed.count) +
                       " in all, and can't go back: up to " + number_text(seat.missed.largest, 3) +
                       " of jump times seconds was not seen in time; where '" + topology_.name(i) +
                       "' leads, by coordination.order, it is");
  }
}

}  // namespace tandem
