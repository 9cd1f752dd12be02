// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/wire/kept_states.hpp"

#include <string>
#include <utility>

#include "tandem/error.hpp"

namespace tandem::wire {

void KeptStates::require_room(std::uint64_t bytes) const {
  if (states_.size() < most_states && bytes_ + bytes <= most_state_bytes) return;
  if (states_.empty()) return;  // one is as large as the model makes it
  throw Error(ErrorCode::not_supported,
              "the session keeps " + std::to_string(states_.size()) + " saved states of " +
                  std::to_string(bytes_) + " bytes; allowed are up to " + std::to_string(most_states) +
                  ", and " + std::to_string(most_state_bytes) + " bytes in all: release some");
}

void KeptStates::keep(StateId id, std::uint64_t bytes) {
  bytes_ += bytes - std::exchange(states_[id], bytes);
}

/// How large its states are is asked once, and again where one is given as bytes.
void KeptStates::keep_saved(Subsystem& subsystem, StateId id) {
  keep(id, bytes_of_one_);
  if (bytes_of_one_ != 0 || !subsystem.info().abilities.serializes_state) return;
  bytes_of_one_ = subsystem.serialize_state(id).size();
  keep(id, bytes_of_one_);
}

/// One that the peer is not told of is not kept.
StateId KeptStates::save(Subsystem& subsystem) {
  require_room(bytes_of_one_);
  const StateId id = subsystem.save_state();
  try {
    keep_saved(subsystem, id);
  } catch (...) {
    release(subsystem, id);
    throw;
  }
  return id;
}

StateId KeptStates::deserialize(Subsystem& subsystem, std::span<const std::byte> bytes) {
  require_room(bytes.size());
  const StateId id = subsystem.deserialize_state(bytes);
  keep(id, bytes.size());
  return id;
}

void KeptStates::release(Subsystem& subsystem, StateId id) {
  subsystem.release_state(id);
  const auto state = states_.find(id);
  if (state == states_.end()) return;
  bytes_ -= state->second;
  states_.erase(state);
}

}  // namespace tandem::wire
