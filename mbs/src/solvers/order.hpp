// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "tandem/mbs/sparse/pattern.hpp"

namespace tandem::mbs::solvers {

/// By column its place in an order in which the band of a symmetric matrix is narrow: reverse Cuthill-McKee,
/// or the columns' own order where that is as narrow. Either triangle of the pattern will do.
std::vector<int> narrow_order(const Pattern& pattern);

}  // namespace tandem::mbs::solvers
