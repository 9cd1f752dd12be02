// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "view/run.hpp"

namespace tandem::view {

/// Whether a column is the coordinate of a point or vector of a mechanism and no output that its file names.
bool drawn_only(const Run& run, const std::string& column);
/// The same of a fixed one, which the drawing knows without the column.
bool stands_still(const Run& run, const std::string& column);

/// The columns that a page plots when it opens: those that the tables [view] of the scenario, or else of its
/// mechanisms, name; else up to four, the judged quantity first, then one of each unit.
std::vector<std::string> plots_at_first(const Run& run);

}  // namespace tandem::view
