// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What a run goes by, as bytes and back.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "../number_text.hpp"
#include "named.hpp"
#include "tandem/coordinator/coordinator.hpp"
#include "tandem/error.hpp"

namespace tandem {
namespace {

constexpr std::int64_t most_rows = std::int64_t{1} << 60;  // that a run gives

bool all_finite(std::span<const double> values) {
  double zero = 0.0;  // NaN if there is one, or an infinity, among the values
  for (const double v : values) zero += v - v;
  return zero == 0.0;
}

}  // namespace

void History::write(ByteWriter& to) const {
  for (const std::int64_t number : {base_, committed_, seeds_, capacity()}) to.put(number);
  to.put_list({data_.data(), static_cast<std::size_t>(samples_.size() * stride())});
  bounds_.write(to);
}

/// The capacity of the other run is not taken over: memory grows anew as far as these rows, which are there,
/// need it, and no sample depends on it.
void History::read(ByteReader& from) {
  const auto base = from.take<std::int64_t>(), committed = from.take<std::int64_t>(),
             seeds = from.take<std::int64_t>();
  from.take<std::int64_t>();  // the capacity
  const auto rows = from.take_list();
  bounds_.read(from);
  const auto count = static_cast<std::int64_t>(rows.size()) / stride();
  if (static_cast<std::int64_t>(rows.size()) != count * stride() || count < 1 || base < 0 ||
      base > most_rows || committed != base + count || seeds < 0 || seeds > committed || !are_rows(rows))
    from.refuse("has a history of subsystem '" + name_ + "' with " + std::to_string(rows.size()) +
                " numbers; allowed are rows of " + std::to_string(stride()) + " that follow each other");
  base_ = base, committed_ = committed, seeds_ = seeds;
  std::int64_t enough = capacity();
  while (count > enough / 2) enough *= 2;
  data_ = rows;
  data_.resize(static_cast<std::size_t>(enough * stride()));
  samples_ = Samples(data_.data(), stride(), enough, count);
}

/// Whether they are what commit() lets pass.
bool History::are_rows(std::span<const double> rows) const {
  double before = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < rows.size(); k += static_cast<std::size_t>(stride())) {
    const auto row = rows.subspan(k, static_cast<std::size_t>(stride()));
    const bool jump = row[1] == 1.0;
    if (!all_finite(row) || !(jump || row[1] == 0.0) || !(row[0] > before || (jump && row[0] == before)))
      return false;
    before = row[0];
  }
  return true;
}

/// Segments that its reader has let go, and may read again where the source takes rows back.
std::int32_t Link::let_go() const {
  const std::int64_t rows = samples_->newest() + 1 - samples_->oldest() - late_;
  return static_cast<std::int32_t>(std::min(rows - count_, first_ - segments_.data()));
}

void Link::write(ByteWriter& to) const {
  const std::int32_t old = spreads() && follows_ ? let_go() : 0;
  to.put(std::uint8_t{been_read_});
  to.put(count_);
  to.put(old);
  to.put(fitted_);
  to.put_list(differences_);
  for (std::size_t l = 0; l < lanes_.size(); ++l)
    for (std::int32_t k = -old; k < count_; ++k) {
      const Segment& s = first_[static_cast<std::int64_t>(l) * capacity_ + k];
      to.put(s.end);
      to.put(s.origin);
      to.put_doubles(s.c);
    }
  to.put(read_from_);
  to.put(expected_);
}

void Link::read(ByteReader& from) {
  late_ = 0;
  been_read_ = from.take<std::uint8_t>() != 0;
  const auto count = from.take<std::int32_t>(), old = from.take<std::int32_t>();
  fitted_ = from.take<std::int64_t>();
  from.take_list(differences_);
  capacity_ = follows_ ? segments_of_lane() : 1;
  check(count, old, from);
  count_ = count;
  segments_.assign(lanes_.size() * static_cast<std::size_t>(capacity_), Segment{});
  first_ = segments_.data() + (follows_ ? samples_->newest() + 1 - samples_->oldest() - count_ : 0);
  for (std::size_t l = 0; l < lanes_.size(); ++l)
    read({first_ - old + static_cast<std::int64_t>(l) * capacity_, static_cast<std::size_t>(old + count_)},
         from);
  read_from_ = from.take<double>();
  expected_ = from.take<double>();
  if (!std::isfinite(read_from_) || !std::isfinite(expected_))
    from.refuse("has a time of reading, or of a jump, that is not finite");
  renew_last();
}

/// Each segment is of a row that is there, and so are the rows that the next one is fitted to.
void Link::check(std::int32_t count, std::int32_t old, const ByteReader& from) const {
  const std::int64_t rows = samples_->newest() + 1 - samples_->oldest(), fewest = follows_ ? 1 : 0;
  if (count < fewest || count > (follows_ ? rows : 0))
    from.refuse("has " + std::to_string(count) + " segments; allowed are " + std::to_string(fewest) + " to " +
                std::to_string(rows));
  if (old < 0 || old > (follows_ ? rows - count : 0))
    from.refuse("has " + std::to_string(old) + " segments from before; allowed are 0 to " +
                std::to_string(rows - count));
  if (fitted_ < 0 || std::min<std::int64_t>(fitted_, rows_looked_at() - 1) > rows)
    from.refuse("has " + std::to_string(fitted_) + " rows to be fitted together, of " + std::to_string(rows) +
                " that are there");
  if (!all_finite(differences_)) from.refuse("has differences of samples that are not finite");
}

void Link::read(std::span<Segment> lane, ByteReader& from) const {
  double before = -std::numeric_limits<double>::infinity();
  for (Segment& s : lane) {
    s.end = from.take<double>();
    s.origin = from.take<double>();
    from.take_doubles(s.c);
    const bool open = held_ && &s == &lane.back() && s.end == std::numeric_limits<double>::infinity();
    if (!all_finite(s.c) || !std::isfinite(s.origin) || !(open || std::isfinite(s.end)) || s.end < before)
      from.refuse("has a segment that is not finite, or ends before the one before it");
    before = s.end;
  }
}

void Exchange::write(ByteWriter& to) const {
  for (const End& end : ends_) end.history.write(to);
  for (const Link& link : links_) link.write(to);
  for (const End& end : ends_)
    for (const Driven& input : end.driven)
      if (input.is_open()) input.write(to);
}

void Exchange::read(ByteReader& from) {
  for (End& end : ends_) end.history.read(from);
  for (Link& link : links_) link.read(from);
  for (End& end : ends_)
    for (Driven& input : end.driven)
      if (input.is_open()) input.read(from);
}

void Coordinator::require_serializable() const {
  std::string names;
  for (int i = 0; i < topology_.size(); ++i)
    if (!topology_.info(i).abilities.serializes_state)
      names += (names.empty() ? "subsystem '" : ", subsystem '") + topology_.name(i) + "'";
  if (!names.empty())
    throw Error(ErrorCode::not_supported,
                names +
                    ": its state can't be given as bytes, which a checkpoint needs; allowed are "
                    "subsystems with the ability serializes_state");
}

void Coordinator::save(ByteWriter& to) const {
  for (int i = 0; i < topology_.size(); ++i) {
    const Seat& seat = this->seat(i);
    to.put_doubles(std::array{seat.time, own_next(i)});
    to.put(std::int32_t{seat.idle_calls});
    for (const std::int64_t number : {seat.told, seat.effort.exchanges, seat.effort.steps}) to.put(number);
    const StateId now = named(topology_.name(i), [&] { return seat.subsystem->save_state(); });
    write_state(i, now, to);
    seat.subsystem->release_state(now);
    write_events(i, to);
  }
  exchange_->write(to);
  if (coordination_.pauses) to.put(schedule_->stop());
}

void Coordinator::write_state(int who, StateId id, ByteWriter& to) const {
  Subsystem& subsystem = *seats_[static_cast<std::size_t>(who)].subsystem;
  const auto bytes = named(topology_.name(who), [&] { return subsystem.serialize_state(id); });
  to.put(std::uint64_t{bytes.size()});
  to.put_bytes(bytes);
}

/// All numbers are looked at before the first subsystem gets its state.
void Coordinator::restore(ByteReader& from) {
  std::vector<std::span<const std::byte>> states, states_back;
  for (std::size_t i = 0; i < seats_.size(); ++i) {
    Seat& seat = seats_[i];
    for (double* time : {&seat.time, &own_next_[i]}) *time = from.take<double>();
    seat.idle_calls = from.take<std::int32_t>();
    seat.call = Seat::Call::none, seat.stop = Stop::limit;  // also where a call had failed
    for (std::int64_t* number : {&seat.told, &seat.effort.exchanges, &seat.effort.steps})
      *number = from.take<std::int64_t>();
    states.push_back(from.take_bytes(from.take<std::uint64_t>()));
    read_events(static_cast<int>(i), from, states_back);
  }
  exchange_->read(from);
  if (coordination_.pauses) restore_stop(from);
  for (int i = 0; i < topology_.size(); ++i) check_seat(i, from), check_events(i, from);
  place_all();
  for (int i = 0; i < topology_.size(); ++i) restore_state(i, states[static_cast<std::size_t>(i)], from);
  restore_back(states_back);
}

/// Where a run that pauses stands.
void Coordinator::restore_stop(ByteReader& from) {
  const auto stop = from.take<double>();
  if (!(stop >= t_start_ && stop <= t_stop_))
    from.refuse("pauses at t = " + number_text(stop) + " s; allowed is a time within the run, from " +
                number_text(t_start_) + " to " + number_text(t_stop_) + " s");
  stop_at(stop);
}

/// Where it stands is the time of its newest sample (of a sampled one the instant of that, or the start),
/// within the span, and its next step ends after that.
void Coordinator::check_seat(int who, const ByteReader& from) {
  const Seat& seat = this->seat(who);
  const double next = own_next_[static_cast<std::size_t>(who)];
  const History& history = exchange_->history(who);
  const bool sampled = topology_.info(who).abilities.sampled,
             in_span = !tolerance_.before(seat.time, t_start_) && !tolerance_.before(t_stop_, seat.time);
  const double newest = history.time(history.newest());
  const bool at_newest =
      seat.time == newest || (sampled && seat.time + topology_.info(who).sampling.latency == newest);
  if (!at_newest || !in_span || !(sampled ? next >= seat.time : next > seat.time))
    from.refuse("has subsystem '" + topology_.name(who) + "' at t = " + number_text(seat.time) +
                " s with a next step to " + number_text(next) +
                " s; allowed is the time of its newest sample, within the run, and a later one");
  if (seat.idle_calls < 0 || seat.idle_calls >= most_idle_calls || seat.told < history.oldest() - 1 ||
      seat.told > history.newest() || seat.effort.exchanges < 0 || seat.effort.steps < 0)
    from.refuse("has a number of calls, steps or samples of subsystem '" + topology_.name(who) +
                "' that no run has");
}

void Coordinator::restore_state(int who, std::span<const std::byte> bytes, const ByteReader& from) {
  const Seat& seat = this->seat(who);
  const Clock clock = named(topology_.name(who), [&] {
    const StateId id = seat.subsystem->deserialize_state(bytes);
    const Clock there = seat.subsystem->restore_state(id);
    seat.subsystem->release_state(id);
    return there;
  });
  if (clock.time != seat.time)
    from.refuse("has the state of subsystem '" + topology_.name(who) + "' at t = " + number_text(clock.time) +
                " s; allowed is " + number_text(seat.time) + " s");
}

}  // namespace tandem
