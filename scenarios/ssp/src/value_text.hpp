// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "structure.hpp"

namespace tandem::ssp {

std::string number(double value);

/// A text of a scenario, where one that begins with $ would stand for something else.
std::string literal(const std::string& text);

/// A value as a scenario gives it to a variable: booleans are 1 and 0 where it has to be a number. An item of
/// an enumeration is what the FMU says, else the file that gives it, else the number that it is written as.
/// Throws Error, which names a line of `file`, for what is no value.
std::string value_text(const fmi::Variable& v, const Given& given, bool as_number,
                       const std::filesystem::path& file);

}  // namespace tandem::ssp
