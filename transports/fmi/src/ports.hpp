// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "settings.hpp"
#include "tandem/subsystem_info.hpp"

namespace tandem::fmi {

/// Numbers in a sample row (after its header), or among the inputs, from `place` on, and the variable that has
/// them.
struct Seat {
  int variable, place, size = 1;
  int end() const { return place + size; }
};

/// That a number in a sample row follows an input at once.
struct Follows {
  int place, input;
};

/// Which variables are ports: inputs and outputs that are numbers, and variables that the settings make outputs.
struct Ports {
  SubsystemInfo info;
  std::vector<Seat> continuous, discrete;  ///< inputs: real ones that may change at any time, and all others
  std::vector<Seat> row;                   ///< outputs with their derivatives that are variables
  std::vector<Seat> derived;               ///< outputs with the seats of derivatives that the FMU is to give
  std::vector<Follows> follows;
  std::vector<Seat> followed;  ///< of the continuous inputs those that outputs follow at once
  std::vector<Seat> asked;     ///< of the continuous inputs those that may be set within a step
};

/// Throws Error(invalid_argument) for an FMU without outputs, and a unit for a port that is not there.
Ports ports_of(const Description& description, const Settings& settings);

}  // namespace tandem::fmi
