// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "guarded_call.hpp"

namespace tandem {

void CSubsystem::require_saving() const {
  if (!info_.abilities.saves_state)
    throw Error(ErrorCode::not_supported, "subsystem '" + info_.name + "' has no ability to save its state");
}

StateId CSubsystem::save_state() {
  require_saving();
  StateId id = 0;
  check(guarded("save_state", [&] { return api_.save_state(self_, &id); }), "save_state");
  return id;
}

Clock CSubsystem::restore_state(StateId id) {
  require_saving();
  tandem_clock clock{};
  check(guarded("restore_state", [&] { return api_.restore_state(self_, id, &clock); }), "restore_state");
  return clock_from(clock);
}

void CSubsystem::release_state(StateId id) {
  require_saving();
  check(guarded("release_state", [&] { return api_.release_state(self_, id); }), "release_state");
}

void CSubsystem::require_serializing() const {
  if (!info_.abilities.serializes_state)
    throw Error(ErrorCode::not_supported,
                "subsystem '" + info_.name + "' has no ability to give its state as bytes");
}

std::vector<std::byte> CSubsystem::serialize_state(StateId id) {
  require_serializing();
  const void* bytes = nullptr;
  std::int64_t size = 0;
  check(guarded("serialize_state", [&] { return api_.serialize_state(self_, id, &bytes, &size); }),
        "serialize_state");
  if (size < 0 || (size > 0 && !bytes))
    throw Error(ErrorCode::invalid_argument, "subsystem '" + info_.name + "' gives a state of " +
                                                 std::to_string(size) + " bytes without them");
  const auto* first = static_cast<const std::byte*>(bytes);
  return {first, first + size};
}

StateId CSubsystem::deserialize_state(std::span<const std::byte> bytes) {
  require_serializing();
  StateId id = 0;
  check(guarded("deserialize_state",
                [&] {
                  return api_.deserialize_state(self_, bytes.data(), static_cast<std::int64_t>(bytes.size()),
                                                &id);
                }),
        "deserialize_state");
  return id;
}

}  // namespace tandem
