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
  for (const double t : {start_, stop_, time_}) to.put(t);
  inputs_.write(to);
  to.put(std::uint8_t{begun_});
  to.put(std::uint8_t{inputs_set_});
  to.put(std::uint8_t{fresh_});
  if (fresh_) {
    to.put_list(at_start_);
    write_started(to);
  }
  return {to.bytes().begin(), to.bytes().end()};
}

void Unit::restore(std::span<const std::byte> bytes) {
  ByteReader from(bytes, info_.name, "state of the FMU");
  if (from.take_text(longest_word) != manifest_.token) from.refuse("it is one of another FMU");
  try {
    read(from);
  } catch (...) {
    reset();
    throw;
  }
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

/// One that stands elsewhere, or was started otherwise, is started anew before it takes the state. Where that
/// fails it is as after reset().
void Unit::read(ByteReader& from) {
  const auto changed = read_changed(from);
  double start, stop, time;
  for (double* t : {&start, &stop, &time}) *t = from.take<double>();
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
  inputs_ = std::move(inputs);
  time_ = time;
  if (fresh) read_started(from);
  from.end();
  begun_ = begun, inputs_set_ = set, fresh_ = fresh;
}

}  // namespace tandem::exported
