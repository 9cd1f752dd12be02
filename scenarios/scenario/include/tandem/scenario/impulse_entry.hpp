// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace tandem::scenario {

/// What a slow side is at a link, as far as it is stated.
struct Effective {
  std::optional<double> mass, stiffness, damping;
  /// Outputs that tell what each force on that side accelerates here, in the order of its links.
  std::vector<std::string> accelerance = {};
};

/// What an impulse surrogate goes between.
struct ImpulseEntry {
  struct Link {
    std::string fast, force, displacement;  ///< instance; input and output of the slow side
    Effective effective;
  };
  std::string slow;  ///< instance
  std::vector<Link> links;
  bool with_stiffness;
};

}  // namespace tandem::scenario
