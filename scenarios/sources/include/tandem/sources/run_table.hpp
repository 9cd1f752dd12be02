// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/text/document.hpp"
#include "tandem/transports/parameters.hpp"

namespace tandem {

/// Takes the values of a file's table [run] that are not given yet, "NAME.KEY" of a table in it, but for start,
/// stop and inputs, which belong to who runs it alone. "$NAME" stands for a parameter of the file, as it is
/// given.
void take_run_table(const text::Document& document, Parameters& to);

}  // namespace tandem
