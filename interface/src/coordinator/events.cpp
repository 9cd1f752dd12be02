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
  const EventSeat& seat = events(who);
  for (const int leader : seat.leaders_back) tell(leader);
  if (!history.jump(history.newest())) return;
  const double t = history.time(history.newest());
  const auto is_seen = [&](int reader) { return jump_seen(who, reader, Member::never).size != 0.0; };
  if (schedule_->kind() == Schedule::Kind::parallel &&
      std::any_of(seat.readers.begin(), seat.readers.end(), is_seen))
    schedule_->end_round_at(t);
  for (const int reader : seat.readers)
    if (tolerance_.before(t, time(reader))) pass_by(reader, who);
  if (std::any_of(seat.carriers.begin(), seat.carriers.end(), is_seen))
    for (const int carrier : seat.carriers) exchange_->expect_jump(carrier, t);
  for (const int reader : seat.readers) place(reader);
}

/// By how much an input of the reader jumps, or one of those with which what it reads jumps at once, and
/// where it does so first, as far as that is before `until`.
Exchange::Jump Coordinator::jump_seen(int who, int reader, double until) const {
  const EventSeat& seat = events(who);
  Exchange::Jump jump = exchange_->jump(who, reader, until);
  if (std::find(seat.of_carriers.begin(), seat.of_carriers.end(), reader) != seat.of_carriers.end())
    for (const int carrier : seat.carriers) jump.add(exchange_->jump(who, carrier, until));
  return jump;
}

/// `reader` stands past an event of `who`. A jump that it sees later, by a lag, it may not have passed.
void Coordinator::pass_by(int reader, int who) {
  const Exchange::Jump jump = jump_seen(who, reader, time(reader));
  if (jump.size == 0.0) return;
  const auto& behind = events(reader).events_behind;  // a follower that a ring let pass keeps no such state
  if (std::find(behind.begin(), behind.end(), who) != behind.end()) return go_back(reader, jump.time);
  EventSeat& seat = events(who);
  const double size = jump.size * (time(reader) - jump.time);
  seat.missed += 1;
  if (size >= seat.most_missed) seat.most_missed = size, seat.missed_by = reader;
}

/// Before an own step of one that may go back: its state, and no longer those from before where all stand
/// that it may go back for.
void Coordinator::remember(int who) {
  auto& back = events(who).back;
  Subsystem& subsystem = *seat(who).subsystem;
  const double earliest = earliest_event(who);
  while (back.size() > 1 && !tolerance_.before(earliest, back[1].time)) {
    subsystem.release_state(back.front().state);
    back.erase(back.begin());
  }
  const StateId state = named(topology_.name(who), [&] { return subsystem.save_state(); });
  back.push_back({state, time(who), exchange_->history(who).newest()});
  exchange_->keep_from(who, back.front().time);
}

/// No event comes before this time [s] that it leads: those that have them stand there or later, or go back
/// there at most.
double Coordinator::earliest_event(int who) const {
  double earliest = Member::never;
  for (const int other : events(who).events_behind)
    earliest = std::min(earliest, earliest_stand(other, earliest_event(other)));
  return earliest;
}

/// Where it stands, or goes back to for an event at t.
double Coordinator::earliest_stand(int who, double t) const {
  const auto& back = events(who).back;
  double stand = time(who);
  for (auto to = back.rbegin(); to != back.rend() && tolerance_.before(t, stand); ++to) stand = to->time;
  return stand;
}

/// To its last own node at or before t; what it gave after that is taken back.
void Coordinator::go_back(int who, double t) {
  auto& back = events(who).back;
  Subsystem& subsystem = *seat(who).subsystem;
  while (back.size() > 1 && tolerance_.before(t, back.back().time)) {
    subsystem.release_state(back.back().state);
    back.pop_back();
  }
  const EventSeat::Back to = back.back();
  exchange_->withdraw(who, exchange_->history(who).newest() - to.row);
  const Clock clock = named(topology_.name(who), [&] { return subsystem.restore_state(to.state); });
  if (clock.time != to.time)
    throw Error(ErrorCode::numerical,
                "subsystem '" + topology_.name(who) + "' was saved at t = " + number_text(to.time) +
                    " s and says that it stands at t = " + number_text(clock.time) + " s when restored");
  subsystem.release_state(to.state);
  back.pop_back();
  events(who).times_back += 1;
  exchange_->rebuild(who);
  if (observer_) observer_->went_back(who, clock.time);
  stand(who, clock);
  forget_jumps(who);
}

/// What it had given is no longer known to its readers: where they were to end steps for that they are not.
void Coordinator::forget_jumps(int who) {
  for (const int carrier : events(who).carriers) exchange_->expect_jump(carrier, -Member::never);
  place_readers(who);
  for (const int reader : events(who).of_carriers) place(reader);
}

/// Those that integrate themselves.
void Coordinator::place_readers(int who) {
  exchange_->each_reader(who, [this](int reader) {
    if (!schedule_->member(reader).sampled) place(reader);
  });
}

/// The last row that is not taken back any more: that of the state which the earliest event leads back to. (A
/// jump with the inputs is told at the begin of a call, and is one row more at that time.)
std::int64_t Coordinator::last_final(int who) const {
  const std::int64_t newest = exchange_->history(who).newest();
  const auto& back = events(who).back;
  if (!seat(who).goes_back || ended_ || back.empty()) return newest;
  const double earliest = earliest_event(who);
  if (!tolerance_.before(earliest, time(who))) return newest;
  const auto to = std::find_if(back.rbegin(), back.rend(), [&](const EventSeat::Back& b) {
    return !tolerance_.before(earliest, b.time);
  });
  return to == back.rend() ? back.front().row : to->row;
}

void Coordinator::note_events() {
  for (int i = 0; i < topology_.size(); ++i) {
    const EventSeat& seat = events(i);
    if (seat.times_back > 0)
      notes_.push_back("subsystem '" + topology_.name(i) + "' went back " + std::to_string(seat.times_back) +
                       " times to events that it had passed");
    if (seat.missed > 0)
      notes_.push_back("subsystem '" + topology_.name(seat.missed_by) + "' had passed events of '" +
                       topology_.name(i) + "', " + std::to_string(seat.missed) +
                       " in all, and can't go back: up to " + number_text(seat.most_missed, 3) +
                       " of jump times seconds was not seen in time; where '" + topology_.name(i) +
                       "' leads, by coordination.order, it is");
  }
}

}  // namespace tandem
