// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "tandem/scenario/comparison.hpp"

namespace tandem::scenario {

/// By how much A is later than B, at most `most` [s]: there the sum over the columns of the squared relative rms is least,
/// by Brent's method in the valleys of a scan. Half as many times have to be compared as where they are most: the ends of
/// two results alone agree too easily.
/// - shifted: compares both with A so much later.
double best_shift(const TimeTable& a, const TimeTable& b, const std::vector<std::string>& names, double most,
                  const std::function<Comparison(double)>& shifted);

}  // namespace tandem::scenario
