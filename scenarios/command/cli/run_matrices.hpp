// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>

#include "tandem/scenario/scenario.hpp"

namespace tandem::cli {

/// What of a mechanism's matrices is written, and where.
struct Matrices {
  std::optional<std::string> folder, times;
  std::string format = "mtx";
};

/// The scenario with the matrices asked for of each mechanism, in a folder of its name. Throws Error for
/// a folder without a name, what is no time of the run, and where there is no mechanism.
scenario::Scenario with_matrices(scenario::Scenario scenario, const Matrices& matrices,
                                 const Builtins& builtins);

}  // namespace tandem::cli
