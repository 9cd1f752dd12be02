// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

namespace tandem::test {

/// All that a stepper, a part of one or a solver remembers.
template <class Remembering>
std::vector<double> memory_of(const Remembering& x) {
  std::vector<double> all;
  x.remember(all);
  return all;
}

}  // namespace tandem::test
