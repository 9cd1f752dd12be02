// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "structure.hpp"

namespace tandem::ssp {

/// How a connector gets its values: from where they begin, through connectors of systems.
struct Chain {
  Node source;  ///< of a component, or of a system that nothing leads to
  std::vector<const Edge*> edges = {};

  /// The line of the last connection.
  int line() const { return edges.back()->line; }
};

/// Throws Error for connectors that lead back to themselves.
Chain chain_to(const Structure& in, const Node& node);

/// gain * value + offset in the units of the ports, after a conversion between these if there is one.
struct Gain {
  double gain = 1.0, offset = 0.0;
  bool converts = false;      ///< between units that differ
  bool keeps_number = false;  ///< the units differ, and numbers are taken as they are
};

/// What a chain between two components makes of a value. Throws Error for units of different kinds. Values of
/// units that tandem does not know are taken as they are, and these are noted.
Gain gain_of(Structure& in, const Chain& chain);

/// The value that the end of a chain is given on the way, beyond what a component gives, in its own unit; null:
/// none. Of several the one that was given last holds.
std::optional<Given> given_through(Structure& in, const Chain& chain);

}  // namespace tandem::ssp
