// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

namespace tandem::stability {

struct Period {
  double length;                    ///< [s]
  std::vector<std::int64_t> steps;  ///< of each length in it
};

/// The shortest time that is a whole multiple of all lengths [s], up to `most` times the largest; nothing if there
/// is none. Lengths that meet within rounding count as meeting.
std::optional<Period> common_period(const std::vector<double>& lengths, std::int64_t most);

}  // namespace tandem::stability
