// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/exported/unit.hpp"

namespace tandem::exported {

namespace {
constexpr std::uint32_t longest_word = 1u << 20;
}

std::vector<std::byte> Unit::state() {
  ByteWriter to;
  to.put_text(manifest_.token);
  write_changed(to);
  for (const double t : {start_, stop_, time_, place_}) to.put(t);
  inputs_.write(to);
  to.put(std::uint8_t{begun_});
  to.put(std::uint8_t{inputs_set_});
  to.put(std::uint8_t{fresh_});
  if (fresh_) {
    to.put_list(at_start_);
    to.put_list(row_);
    to.put(clock_.time), to.put(clock_.next_time), to.put(static_cast<std::int32_t>(clock_.stop));
    const StateId id = subsystem_->save_state();
    to.put_bytes(subsystem_->serialize_state(id));
    subsystem_->release_state(id);
  }
  return {to.bytes().begin(), to.bytes().end()};
}

void Unit::restore(std::span<const std::byte> bytes) {
  ByteReader from(bytes, info_.name, "state of the FMU");
  if (from.take_text(longest_word) != manifest_.token) from.refuse("it is one of another FMU");
  read(from);
}

void Unit::write_changed(ByteWriter& to) const {
  to.put(static_cast<std::uint32_t>(changed_.size()));
  for (const auto& [name, value] : changed_) {
    to.put_text(name);
    const auto* number = std::get_if<double>(&value);
    to.put(std::uint8_t{number != nullptr});
    number ? to.put(*number) : to.put_text(std::get<std::string>(value));
  }
}

std::map<std::string, Parameters::Value> Unit::read_changed(ByteReader& from) const {
  std::map<std::string, Parameters::Value> changed;
  for (std::uint64_t left = from.take_count(5); left > 0; --left) {
    const std::string name = from.take_text(longest_word);
    if (from.take<std::uint8_t>() != 0)
      changed[name] = from.take<double>();
    else
      changed[name] = from.take_text(longest_word);
  }
  return changed;
}

/// One that stands elsewhere, or was started otherwise, is started anew before it takes the state.
void Unit::read(ByteReader& from) {
  const auto changed = read_changed(from);
  double start, stop, time, place;
  for (double* t : {&start, &stop, &time, &place}) *t = from.take<double>();
  Inputs inputs = inputs_;
  inputs.read(from);
  const bool begun = from.take<std::uint8_t>() != 0, set = from.take<std::uint8_t>() != 0,
             fresh = from.take<std::uint8_t>() != 0;
  const auto at_start = fresh ? from.take_list() : at_start_;
  const bool alike =
      fresh_ && changed == changed_ && start == start_ && stop == stop_ && at_start == at_start_;
  fresh_ = false;  // until all is read
  if (changed != changed_) {
    subsystem_.reset();
    changed_ = changed;
    parameters_ = file_parameters();
  }
  start_ = start, stop_ = stop;
  if (fresh && !alike) {
    inputs_ = Inputs(at_start);
    this->start();
    fresh_ = false;
  }
  if (fresh) read_started(from);
  from.end();
  inputs_ = std::move(inputs);
  time_ = time, place_ = place, begun_ = begun, inputs_set_ = set, fresh_ = fresh;
}

void Unit::read_started(ByteReader& from) {
  std::vector<double> row(static_cast<std::size_t>(info_.row_size() - Samples::header));
  from.take_list(row);
  Clock clock{};
  clock.time = from.take<double>(), clock.next_time = from.take<double>();
  clock.stop = static_cast<Stop>(from.take<std::int32_t>());
  const StateId id = subsystem_->deserialize_state(from.take_bytes(from.left()));
  subsystem_->restore_state(id);
  subsystem_->release_state(id);
  row_ = std::move(row), clock_ = clock;
}

}  // namespace tandem::exported
