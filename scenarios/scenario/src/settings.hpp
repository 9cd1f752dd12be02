// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tandem/scenario/scenario.hpp"
#include "tandem/text/section.hpp"

namespace tandem::scenario {

using text::described;
using text::Section;

/// How a difference is measured: the keys norm, from, to and shift.
Measure read_measure(Section& section, const Scenario& of);

/// The tables coordination, span, record, reference, judge, view and ladder, each with what reads it into a
/// scenario whose subsystems are known. Throw Error.
const std::vector<std::pair<std::string, std::function<void(Section&, Scenario&)>>>& settings();

}  // namespace tandem::scenario
