// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/text/document.hpp"
#include "tandem/transports/parameters.hpp"

namespace tandem {

/// Takes the values of a file's table [run] that are not given yet, but for start, stop and tables (inputs),
/// which belong to who runs it alone.
void take_run_table(const text::Document& document, Parameters& to);

}  // namespace tandem
