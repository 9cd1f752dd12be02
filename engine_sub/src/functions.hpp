// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace tandem::engine {

using Function = double (*)(double);
using Function2 = double (*)(double, double);

template <class F>
struct Named {
  const char* name;
  F call;
};

/// What the blocks `function` and `function2` know.
extern const std::vector<Named<Function>> functions;
extern const std::vector<Named<Function2>> functions2;

}  // namespace tandem::engine
