// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "scenario/scenario.hpp"

namespace tandem::cli {

/// What of a mechanism's matrices is written, and where.
struct Matrices {
  std::string folder, times, format = "mtx";
};

/// The scenario with the matrices asked for of each mechanism, in a folder of its name. Throws Error for
/// times outside the run, and where there is no mechanism.
scenario::Scenario with_matrices(scenario::Scenario scenario, const Matrices& matrices);

}  // namespace tandem::cli
