// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "tandem/charts/gnuplot.hpp"

namespace tandem::charts {

/// Of points (cost, error), those for which no other is as cheap and as accurate; by rising cost, so by
/// falling error.
std::vector<Point> pareto_front(std::vector<Point> points);

}  // namespace tandem::charts
