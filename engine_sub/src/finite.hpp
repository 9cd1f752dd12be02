// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <bit>
#include <cstdint>

namespace tandem::engine {

/// 0 for a finite number and nothing else: x - x is +0 then, else not a number. Without a branch, so that many
/// are looked at side by side.
inline std::uint64_t not_finite(double x) { return std::bit_cast<std::uint64_t>(x - x); }

inline bool all_finite(const double* values, int count) {
  std::uint64_t bits = 0;
  for (int k = 0; k < count; ++k) bits |= not_finite(values[k]);
  return bits == 0;
}

}  // namespace tandem::engine
