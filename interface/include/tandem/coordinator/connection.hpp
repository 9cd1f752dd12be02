// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>

#include "tandem/coordinator/reconstruction.hpp"

namespace tandem {

/// What a reader gets is later than what the source gave by: nothing; one own step of the reader (memory);
/// one communication step (delay). Both of the latter break an algebraic loop.
enum class Lag { none, memory, delay };

/// One line between ports, as a scenario states it. Ports are "instance.port", or "instance.port[i]" for one
/// element.
struct Connection {
  std::string from, to;
  std::optional<Reconstruction> how;  ///< of a held output none, or mean
  double gain = 1.0, offset = 0.0;    ///< input = gain * output + offset, after conversion of units
  bool add = false;                   ///< may share its input with others that say the same; they are summed
  bool convert = false;               ///< convert between units of one quantity
  Lag lag = Lag::none;
};

/// One scalar line of a checked connection (flattened indices).
struct Line {
  int source, output;
  int reader, input;
  Reconstruction how;
  double gain, offset;
  Lag lag;
};

}  // namespace tandem
