// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace tandem::scenario {

/// The source of the entry that a surrogate has among subsystems: "builtin:" and this.
inline constexpr const char* impulse_model = "impulse_surrogate";

/// How the reaction of a slow side reaches the fast one: by its reactive inputs (reaction.h), or by a surrogate beside it.
enum class Carrier {
  automatic,  ///< the first where the fast side has them
  reactive,
  surrogate
};

/// What a slow side is at a link, as far as it is stated.
struct Effective {
  std::optional<double> mass, stiffness, damping;
  /// Outputs that tell what each force on that side accelerates here, in the order of its links.
  std::vector<std::string> accelerance = {};
  std::optional<std::string> velocity = {};  ///< the output that is the displacement's rate
};

/// What an impulse surrogate goes between.
struct ImpulseEntry {
  enum class Kind { plain, stiffness, taylor };
  struct Link {
    std::string fast, force, displacement;  ///< instance; input and output of the slow side
    Effective effective;
  };
  std::string slow;  ///< instance
  std::vector<Link> links;
  Kind kind;

  const char* name() const {
    return kind == Kind::taylor      ? "impulse_taylor"
           : kind == Kind::stiffness ? "impulse_stiffness"
                                     : "impulse_plain";
  }
};

/// "x.by.F" of the ports "slow.x" and "slow.F": the output of a mechanism that tells it.
inline std::string accelerance_port(const std::string& displacement, const std::string& force) {
  const auto port = [](const std::string& name) { return name.substr(name.find('.') + 1); };
  return port(displacement) + ".by." + port(force);
}

}  // namespace tandem::scenario
