// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "tandem/text/expression.hpp"

namespace tandem::study {

/// As a cell of a table: a number in the fewest digits that read back the same.
std::string cell_of(const text::FileValue& value);

/// The cells of these columns with commas between them; empty for one that the row has not.
std::string row_key(const std::vector<std::string>& columns, const text::FileValues& row);
/// "voltage = 50, schedule = parallel".
std::string row_text(const std::vector<std::string>& columns, const text::FileValues& row);

}  // namespace tandem::study
