// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "tandem/nearest.hpp"

namespace tandem::scenario {

/// "a, b, c", or "none".
inline std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "none" : text;
}

/// "subsystem 'fsat' is not there; did you mean 'fast'? There are: fast, slow"
inline std::string unknown(const std::string& kind, const std::string& found,
                           const std::vector<std::string>& known) {
  const std::string near = nearest(found, known);
  return kind + " '" + found + "' is not there" + (near.empty() ? "." : "; did you mean '" + near + "'?") +
         " There are: " + listed(known);
}

}  // namespace tandem::scenario
