// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "tandem/error.hpp"

namespace tandem::mbs {

/// Throws Error for an own step [s] that is not allowed.
inline void check_step(const std::string& owner, double step) {
  if (!(step > 0.0) || !std::isfinite(step))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("{}: step is {} s; allowed is a finite number above 0", owner, step));
}

}  // namespace tandem::mbs
