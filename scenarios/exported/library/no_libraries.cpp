// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// An FMU has tandem's own solvers and Eigen's alone.
#include "solvers/order.hpp"
#include "solvers/solvers.hpp"

namespace tandem::mbs::solvers {

std::vector<SolverEntry> library_solvers() { return {}; }
std::vector<int> dissection_order(const Pattern&) { return {}; }

}  // namespace tandem::mbs::solvers
