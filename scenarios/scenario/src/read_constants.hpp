// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tandem/text/section.hpp"

namespace tandem::scenario {

/// Puts the table [constants] of a scenario into `to`, which is what stands behind `root`. Each may be of the
/// others, in any order. Gives those that are numbers. Throws Error with file and line for a name that is not there, and for a ring of them.
std::vector<std::pair<std::string, double>> read_constants(text::Section& root, text::Values& to);

/// The constants that texts of the file name. Refuses another one that the command line or a study has set: it would be
/// without effect.
std::set<std::string> named_constants(const text::Document& document);

}  // namespace tandem::scenario
