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

/// "x.by.F" of the ports "slow.x" and "slow.F": the output of a mechanism that tells it.
inline std::string accelerance_port(const std::string& displacement, const std::string& force) {
  const auto port = [](const std::string& name) { return name.substr(name.find('.') + 1); };
  return port(displacement) + ".by." + port(force);
}

}  // namespace tandem::scenario
