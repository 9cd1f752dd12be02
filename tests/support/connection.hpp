// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "tandem/coordinator/topology.hpp"

namespace tandem::test {

/// how: "" for none, as of a held output.
inline Connection connection(const std::string& from, const std::string& to,
                             const std::string& how = "lagrange0", Lag lag = Lag::none) {
  Connection c{.from = from, .to = to, .how = {}, .lag = lag};
  if (!how.empty()) c.how = Reconstruction::parse(how);
  return c;
}
inline Connection added(Connection c) {
  c.add = true;
  return c;
}

}  // namespace tandem::test
