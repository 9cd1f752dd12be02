// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What a run goes by at events, as bytes and back.
#include <string>
#include <vector>

#include "../number_text.hpp"
#include "named.hpp"
#include "tandem/coordinator/coordinator.hpp"

namespace tandem {

void Coordinator::write_events(int who, ByteWriter& to) const {
  const EventSeat& seat = events(who);
  to.put(seat.times_back);
  to.put(seat.missed);
  to.put(seat.most_missed);
  to.put(std::int32_t{seat.missed_by});
  to.put(std::uint32_t(seat.back.size()));
  for (const EventSeat::Back& back : seat.back) {
    to.put(back.time);
    to.put(back.row);
    write_state(who, back.state, to);
  }
}

/// The states that it may go back to are added to the list, as bytes.
void Coordinator::read_events(int who, ByteReader& from, std::vector<std::span<const std::byte>>& states) {
  EventSeat& seat = events(who);
  forget_states(who);
  seat.times_back = from.take<std::int64_t>();
  seat.missed = from.take<std::int64_t>();
  seat.most_missed = from.take<double>();
  seat.missed_by = from.take<std::int32_t>();
  seat.back.resize(from.take_count(2 * sizeof(double) + sizeof(std::uint64_t)));
  for (EventSeat::Back& back : seat.back) {
    back.time = from.take<double>();
    back.row = from.take<std::int64_t>();
    states.push_back(from.take_bytes(from.take<std::uint64_t>()));
  }
}

/// Those that it might go back to.
void Coordinator::forget_states(int who) {
  for (const EventSeat::Back& back : events(who).back)
    if (back.state != EventSeat::Back::none) seat(who).subsystem->release_state(back.state);
  events(who).back.clear();
}

void Coordinator::forget_states() {
  for (int i = 0; i < topology_.size(); ++i) forget_states(i);
}

void Coordinator::check_events(int who, const ByteReader& from) {
  const EventSeat& seat = events(who);
  const History& history = exchange_->history(who);
  double before = t_start_;
  for (const EventSeat::Back& back : seat.back) {
    if (!this->seat(who).goes_back || tolerance_.before(back.time, before) || back.row < history.oldest() ||
        back.row > history.newest() || history.time(back.row) != back.time)
      from.refuse("has a state of subsystem '" + topology_.name(who) + "' at t = " + number_text(back.time) +
                  " s to go back to; allowed are those at samples that are there, if it may go back");
    before = back.time;
  }
  if (seat.missed_by < -1 || seat.missed_by >= topology_.size() || seat.missed < 0 ||
      (seat.missed > 0 && seat.missed_by < 0) || seat.times_back < 0)
    from.refuse("has a number of events of subsystem '" + topology_.name(who) + "' that no run has");
  if (!seat.back.empty()) exchange_->keep_from(who, seat.back.front().time);
}

void Coordinator::restore_back(std::span<const std::span<const std::byte>> states) {
  auto bytes = states.begin();
  for (int i = 0; i < topology_.size(); ++i)
    for (EventSeat::Back& back : events(i).back)
      back.state = named(topology_.name(i), [&] { return seat(i).subsystem->deserialize_state(*bytes++); });
}

}  // namespace tandem
