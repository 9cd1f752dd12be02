// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

namespace tandem::stability {

struct Period {
  double length = 0.0;  ///< [s]: up to where the first of the lengths ends; the last steps of others are cut
  double last = 0.0;    ///< [s]: up to where the last of them ends
  std::vector<std::int64_t> steps = {};  ///< of each length in it
  double apart = 0.0;                    ///< by how much their ends lie apart, at most, as a part of a step
};

/// The shortest time in which so many of each length [s] end together, of up to most_steps of the largest; to rounding,
/// else to a thousandth of each, else as nearly as any. start [s]: lengths are differences of times from there on.
Period common_period(const std::vector<double>& lengths, double start);

}  // namespace tandem::stability
