// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "tandem/mbs/sparse/linear_solver.hpp"

namespace tandem::mbs {

/// What it takes to eliminate a symmetric pattern.
struct EliminationCost {
  int columns;        ///< n
  int band_width;     ///< w, in an order that makes it narrow
  double entries;     ///< of L below its diagonal, after minimum degree
  double operations;  ///< multiplications of L D L^T, after minimum degree
};
EliminationCost elimination_cost(const Pattern& pattern);

/// The solver that `auto` takes: that of which the least time is expected, from what was measured of each
/// (docs/sparse.md), among those of this build.
std::string solver_choice(MatrixKind kind, const Pattern& pattern);

}  // namespace tandem::mbs
