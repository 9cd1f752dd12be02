// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "instance.hpp"

namespace tandem::checks {

/// Throws Broken or LeftOut.
struct Check {
  const char* name;
  void (*run)(const Subject& of);
};

// By theme, one file each.
extern const std::vector<Check> starts, steps, events, states, samples, reactions;

}  // namespace tandem::checks
