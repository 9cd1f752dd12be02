// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "cli/commands.hpp"

namespace tandem::cli {

/// Messages go to standard error, each a line that begins with "tandem:", and to the log file if one is named; results go
/// to standard output.
void set_up_log(const Context& context, const std::string& file);

/// Whether messages could not be written to that file.
bool has_log_failed();

}  // namespace tandem::cli
