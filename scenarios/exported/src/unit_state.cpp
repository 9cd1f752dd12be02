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

Unit::Kept Unit::read_kept(ByteReader& from) const {
  Kept kept{read_changed(from), 0.0, 0.0, 0.0, inputs_};
  for (double* t : {&kept.start, &kept.stop, &kept.time}) *t = from.take<double>();
  kept.inputs.read(from);
  for (bool* flag : {&kept.begun, &kept.inputs_set, &kept.fresh}) *flag = from.take<std::uint8_t>() != 0;
  kept.fresh ? void(kept.at_start = from.take_list()) : from.end();
  return kept;
}

/// One that stands elsewhere, or was started otherwise, is started anew before it takes the state.
void Unit::take_up(const Kept& kept) {
  fresh_ = false;
  if (kept.changed != changed_) {
    subsystem_.reset();
    changed_ = kept.changed;
    parameters_ = file_parameters();
  }
  start_ = kept.start, stop_ = kept.stop;
  if (!kept.fresh) return;
  inputs_ = Inputs(kept.at_start);
  start();
  fresh_ = false;
}

/// Where that fails it is as after reset(); else nothing changes that is refused.
void Unit::read(ByteReader& from) {
  Kept kept = read_kept(from);
  const bool alike = fresh_ && kept.fresh && kept.changed == changed_ && kept.start == start_ &&
                     kept.stop == stop_ && kept.at_start == at_start_;
  try {
    if (!alike) take_up(kept);
    if (kept.fresh) read_started(from, kept.time, kept.inputs);
  } catch (...) {
    if (!alike) reset();
    throw;
  }
  inputs_ = std::move(kept.inputs), time_ = kept.time;
  begun_ = kept.begun, inputs_set_ = kept.inputs_set, fresh_ = kept.fresh;
}

}  // namespace tandem::exported
