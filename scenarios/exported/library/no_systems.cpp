// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// In an FMU a scenario is a file of its own, and no system of SSP.
#include "tandem/input_file.hpp"
#include "tandem/scenario/file_text.hpp"
#include "tandem/text/nesting.hpp"

namespace tandem::scenario {

FileText file_text(const std::filesystem::path& file) { return {read_file(file, text::longest_document)}; }

}  // namespace tandem::scenario
