// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <deque>
#include <string>
#include <vector>

#include "references.hpp"
#include "row_run.hpp"

namespace tandem::study {

/// What a sweep would do, in lines: Sweep::plan(). runners: by table.
std::vector<std::string> plan(const Study& study, const std::deque<RowRunner>& runners,
                              References& references);

}  // namespace tandem::study
