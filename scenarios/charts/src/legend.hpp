// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "points.hpp"

namespace tandem::charts {

/// Of a chart of points: its colours, its markers, and the lines in it. has_floor: whether the error of the
/// reference is among these.
std::vector<std::vector<Curve>> legends(const Chart& chart, const Points& points, bool has_floor);

}  // namespace tandem::charts
