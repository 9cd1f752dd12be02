// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "tandem/engine/program.hpp"

// What a diagram is made of while it is compiled.
namespace tandem::engine {

/// A signal while a diagram is compiled.
struct Slot {
  enum class Kind { unknown, state, time, input, held, result, constant, past } kind = Kind::unknown;
  double start = 0.0;
  std::string name = {};
  std::string block = {};     ///< that makes it
  std::string where = {};     ///< of a name that nobody has defined: where it is used
  int same_as = -1;           ///< of a name: the signal that it stands for
  int rate = -1;              ///< of a state: its derivative
  int scope = 0;              ///< of a name
  int first = -1, count = 0;  ///< of those that it stands together with
  int size = 1;               ///< slots in the image
  std::string user = {};  ///< of a name: the block that was the first to use it; empty: an output or a limit
};

/// The names of one diagram: of the whole, or of one that stands in a block.
struct Scope {
  std::string prefix = {};  ///< "gearbox.", before its blocks' names
  std::filesystem::path folder = {};
  int trigger = -1;  ///< the event at which alone it is evaluated; -1: always
};

/// Operations that make one signal, in their order.
struct Step {
  int out;
  std::vector<Operation> operations;
  std::string block;
  int count = 1;  ///< signals from `out` on
};

struct Event {
  enum class Kind { crossing, periodic, own_step } kind;
  int signal = -1, sign = -1;  ///< the second of a periodic one: its count
  Crossing::Direction direction = Crossing::Direction::rising;
  double period = 0.0, offset = 0.0;
  std::vector<Update> updates = {};
  std::string block = {};
  bool sees_start = false, repeats = false;
  /// What its updates make: a mode, which other signals want just so at any time; a state that is where they
  /// put it but for rounding, as it has reached a limit there; or something else.
  enum class Effect { any, mode, limit } effect = Effect::any;
  int bound = -1;
};

}  // namespace tandem::engine
