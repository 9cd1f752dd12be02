// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

namespace tandem {

/// Equations about a state x and inputs u: changes obey x' = A x + B u, y = C x + D u. Matrices by rows, in
/// the units of states and ports; x in the order of Subsystem::states(), u and y by scalars.
struct Linearized {
  std::vector<double> a, b, c, d;
};

}  // namespace tandem
