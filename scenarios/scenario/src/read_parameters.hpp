// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "tandem/scenario/scenario.hpp"
#include "tandem/text/document.hpp"
#include "tandem/text/values.hpp"

namespace tandem::scenario {

/// A table of parameters but the key `but`. What stands in a table within is named "table.key", a name in a
/// list is a flag "list.name", and a list of numbers is their text with blanks between. constants: what texts
/// that begin with $ stand for; null: they are texts. Throws Error with the place of what is none of these.
std::vector<Parameter> read_parameters(const text::Document& document, const toml::table& table,
                                       const std::string& path, const text::Values* constants,
                                       const std::string& but);

}  // namespace tandem::scenario
