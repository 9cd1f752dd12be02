// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What a run goes by, as bytes and back.
#include <array>
#include <string>

#include "../number_text.hpp"
#include "named.hpp"
#include "tandem/coordinator/coordinator.hpp"
#include "tandem/error.hpp"

namespace tandem {

void History::write(ByteWriter& to) const {
  for (const std::int64_t number : {base_, committed_, seeds_, capacity_}) to.put(number);
  to.put_list({data_.data(), static_cast<std::size_t>(samples_.size() * stride_)});
}

void History::read(ByteReader& from) {
  const auto base = from.take<std::int64_t>(), committed = from.take<std::int64_t>(),
             seeds = from.take<std::int64_t>(), capacity = from.take<std::int64_t>();
  const auto rows = from.take_list();
  const auto count = static_cast<std::int64_t>(rows.size()) / stride_;
  if (static_cast<std::int64_t>(rows.size()) != count * stride_ || capacity < count || base < 0 ||
      committed < base || committed > base + count)
    from.refuse("has a history of subsystem '" + name_ + "' with " + std::to_string(rows.size()) +
                " numbers; allowed are rows of " + std::to_string(stride_));
  base_ = base, committed_ = committed, seeds_ = seeds, capacity_ = capacity;
  data_ = rows;
  data_.resize(static_cast<std::size_t>(capacity_ * stride_));
  samples_ = Samples(data_.data(), stride_, capacity_, count);
}

void Link::write(ByteWriter& to) const {
  to.put(std::uint8_t{been_read_});
  to.put(count_);
  to.put(fitted_);
  to.put_list(differences_);
  for (std::size_t l = 0; l < lanes_.size(); ++l)
    for (std::int32_t k = 0; k < count_; ++k) {
      const Segment& s = first_[static_cast<std::int64_t>(l) * capacity_ + k];
      to.put(s.end);
      to.put(s.origin);
      to.put_doubles(s.c);
    }
}

void Link::read(ByteReader& from) {
  been_read_ = from.take<std::uint8_t>() != 0;
  const auto count = from.take<std::int32_t>();
  fitted_ = from.take<std::int64_t>();
  from.take_list(differences_);
  capacity_ = follows_ ? samples_->capacity() : 1;
  if (count < 0 || count > capacity_)
    from.refuse("has " + std::to_string(count) + " segments; allowed are up to " + std::to_string(capacity_));
  count_ = count;
  segments_.assign(lanes_.size() * static_cast<std::size_t>(capacity_), Segment{});
  first_ = segments_.data();
  for (std::size_t l = 0; l < lanes_.size(); ++l)
    for (std::int32_t k = 0; k < count_; ++k) {
      Segment& s = first_[static_cast<std::int64_t>(l) * capacity_ + k];
      s.end = from.take<double>();
      s.origin = from.take<double>();
      from.take_doubles(s.c);
    }
}

void Exchange::write(ByteWriter& to) const {
  for (const End& end : ends_) end.history.write(to);
  for (const Link& link : links_) link.write(to);
}

void Exchange::read(ByteReader& from) {
  for (End& end : ends_) end.history.read(from);
  for (Link& link : links_) link.read(from);
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
    const Seat& seat = seats_[static_cast<std::size_t>(i)];
    const Member& member = members_[static_cast<std::size_t>(i)];
    to.put_doubles(std::array{seat.time, member.time, member.next});
    to.put(std::int32_t{seat.idle_calls});
    for (const std::int64_t number : {seat.told, seat.effort.exchanges, seat.effort.steps}) to.put(number);
    const auto bytes = named(topology_.name(i), [&] {
      const StateId id = seat.subsystem->save_state();
      auto state = seat.subsystem->serialize_state(id);
      seat.subsystem->release_state(id);
      return state;
    });
    to.put(std::uint64_t{bytes.size()});
    to.put_bytes(bytes);
  }
  exchange_->write(to);
}

void Coordinator::restore(ByteReader& from) {
  for (int i = 0; i < topology_.size(); ++i) {
    Seat& seat = seats_[static_cast<std::size_t>(i)];
    Member& member = members_[static_cast<std::size_t>(i)];
    for (double* time : {&seat.time, &member.time, &member.next}) *time = from.take<double>();
    seat.idle_calls = from.take<std::int32_t>();
    for (std::int64_t* number : {&seat.told, &seat.effort.exchanges, &seat.effort.steps})
      *number = from.take<std::int64_t>();
    const auto bytes = from.take_bytes(from.take<std::uint64_t>());
    const Clock clock = named(topology_.name(i), [&] {
      const StateId id = seat.subsystem->deserialize_state(bytes);
      const Clock there = seat.subsystem->restore_state(id);
      seat.subsystem->release_state(id);
      return there;
    });
    if (clock.time != seat.time)
      from.refuse("has the state of subsystem '" + topology_.name(i) + "' at t = " + number_text(clock.time) +
                  " s; allowed is " + number_text(seat.time) + " s");
  }
  exchange_->read(from);
}

}  // namespace tandem
