// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "tandem/mbs/mechanism/description.hpp"

namespace tandem::mbs {

/// Where the coordinates of a description's points, vectors and relative coordinates begin in q: variable
/// points and vectors in their order, relative coordinates, fixed points and vectors, then zeros.
struct Numbering {
  explicit Numbering(const Description& description);

  int of(const Coordinate& c) const {
    return c.entity >= 0 ? entity[static_cast<std::size_t>(c.entity)] + c.axis
                         : relative[static_cast<std::size_t>(c.relative)];
  }

  std::vector<int> entity, relative;        ///< first coordinate of each
  std::vector<std::string> variable_names;  ///< "P.x", "theta"
  int variables = 0, zero = 0;              ///< zero: first of as many zeros as there are dimensions
  int coordinates = 0;
};

}  // namespace tandem::mbs
