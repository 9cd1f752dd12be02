// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <map>
#include <span>

#include "tandem/subsystem.hpp"

namespace tandem::wire {

/// Saved states that a session keeps at a time. With a request and a reply of usual_longest each, a session
/// takes at most 160 MiB beside its subsystem's own memory.
constexpr std::size_t most_states = 1000;
constexpr std::uint64_t most_state_bytes = std::uint64_t{1} << 25;

/// The states that a session's subsystem keeps for the peer, which may leave them for as long as it likes,
/// but only so many.
class KeptStates {
 public:
  /// These throw what the subsystem throws, and the first two Error(not_supported) where there is no room.
  StateId save(Subsystem& subsystem);
  StateId deserialize(Subsystem& subsystem, std::span<const std::byte> bytes);
  void release(Subsystem& subsystem, StateId id);

 private:
  void require_room(std::uint64_t bytes) const;
  void keep(StateId id, std::uint64_t bytes);
  void keep_saved(Subsystem& subsystem, StateId id);

  std::map<StateId, std::uint64_t> states_;  ///< saved ones that are not released, with their bytes
  std::uint64_t bytes_ = 0;                  ///< of all of them
  std::uint64_t bytes_of_one_ = 0;           ///< as far as it is known
};

}  // namespace tandem::wire
