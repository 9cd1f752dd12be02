// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "tandem/text/document.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::cli {

/// Throws Error for what a run of a mechanism or a diagram would refuse: a start that can't be, and what its
/// table [run] says. Without that table nothing is checked. overrides: "KEY=VALUE", which the document has.
void check_run(const text::Document& document, const std::vector<std::string>& overrides,
               const Builtins& builtins);

}  // namespace tandem::cli
