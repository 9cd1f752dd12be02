// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <cstdint>

#include "tandem/coordinator/history.hpp"

namespace tandem {

/// Whether a row is at a multiple of a step [s], and the first one there: events end steps elsewhere, and a
/// jump has two rows.
inline bool on_grid(const History& history, std::int64_t row, double step) {
  const double steps = history.time(row) / step;
  return std::abs(steps - std::round(steps)) < 1e-6 && !history.jump(row);
}

}  // namespace tandem
