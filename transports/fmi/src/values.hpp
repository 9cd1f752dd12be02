// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "settings.hpp"

namespace tandem::fmi {

/// Of the parameters "set.NAME". Sizes of arrays are those of the description from now on. Throws
/// Error(invalid_argument) for a variable that can't be set and a value that it can't have.
std::vector<Setting> take_values(Description& description, Parameters& parameters);

/// Throws Error(invalid_argument).
[[noreturn]] void refuse(const std::string& sentence);
/// what: "parameter set: variable". Lists the names that are known, or of many the nearest.
[[noreturn]] void refuse_name(const std::string& what, const std::string& name,
                              std::vector<std::string> known);

}  // namespace tandem::fmi
