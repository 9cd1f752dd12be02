// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <string>

namespace tandem::fmi {

/// Of a call, by the numbers of both versions.
enum class Status : unsigned { ok, warning, discard, error, fatal, pending };

/// Of a number that an FMU gives, which may be any.
inline bool is_good(int status) {
  return static_cast<unsigned>(status) <= static_cast<unsigned>(Status::warning);
}

/// A function of an FMU's library, with its whole name; null where the FMU says that it has it not.
template <class Signature>
struct Function {
  Signature* call = nullptr;
  std::string name = {};
};
/// One of an instance, that gives a status.
template <class... Arguments>
using Call = Function<int(void* instance, Arguments...)>;

/// The functions that are the same in both versions, but for their names.
struct Functions {
  Function<const char*()> get_version;
  Function<void(void* instance)> free_instance;
  Call<> exit_initialization, terminate, reset;

  Call<void**> get_state, free_state;
  Call<void*> set_state;
  Call<void*, std::size_t*> state_size;
  Call<void*, char*, std::size_t> serialize;
  Call<const char*, std::size_t, void**> deserialize;

  Call<> enter_events, enter_continuous_time;
  Call<double> set_time;
  Call<const double*, std::size_t> set_states;
  Call<double*, std::size_t> get_states, get_rates, get_indicators;
};

}  // namespace tandem::fmi
