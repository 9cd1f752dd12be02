// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "tandem/error.hpp"

namespace tandem::engine {

/// `where`: a file and line, or nothing.
[[noreturn]] inline void refuse(const std::string& where, const std::string& sentence) {
  throw Error(ErrorCode::invalid_argument, where.empty() ? sentence : where + ": " + sentence);
}

}  // namespace tandem::engine
