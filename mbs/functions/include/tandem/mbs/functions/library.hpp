// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <memory>

#include "tandem/mbs/functions/functions.hpp"

namespace tandem::mbs {

/// The functions of a shared library, of which model_functions.h is the interface. Throws Error for a file
/// that can't be loaded, has not the symbol tandem_model, another version, a table or an info that lacks
/// something.
std::unique_ptr<Functions> open_library(const std::filesystem::path& file);

}  // namespace tandem::mbs
