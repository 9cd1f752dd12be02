// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <cstdint>

#include "tandem/coordinator/history.hpp"

namespace tandem {

/// Whether a row is at a multiple of a step [s], and the first one there: events end steps elsewhere, be it
/// next to a multiple, and a jump has two rows.
inline bool on_grid(const History& history, std::int64_t row, double step) {
  const auto steps = [&](std::int64_t r) { return history.time(r) / step; };
  const auto near = [&](std::int64_t r) { return std::abs(steps(r) - std::round(steps(r))) < 1e-6; };
  const bool again =
      row > history.oldest() && near(row - 1) && std::round(steps(row - 1)) == std::round(steps(row));
  return near(row) && !again;
}

}  // namespace tandem
