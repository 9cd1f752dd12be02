// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "tandem/coordinator/topology.hpp"

namespace tandem::test {

inline Connection connection(const std::string& from, const std::string& to,
                             const std::string& how = "lagrange0", Lag lag = Lag::none) {
  return {.from = from, .to = to, .how = Reconstruction::parse(how), .lag = lag};
}
inline Connection added(Connection c) {
  c.add = true;
  return c;
}

}  // namespace tandem::test
