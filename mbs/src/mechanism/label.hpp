// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "tandem/mbs/model.hpp"

namespace tandem::mbs {

/// What Structure says of a constraint. Size 0: 1, or the structure's length if it is off by m.
struct Label {
  std::string name, unit, place;
  double size = 0.0;
};

inline void label(Structure& to, const Label& constraint) {
  to.constraint_names.push_back(constraint.name);
  to.constraint_units.push_back(constraint.unit);
  to.constraint_places.push_back(constraint.place);
  const double size = constraint.unit == "m" ? to.length : 1.0;
  to.constraint_sizes.push_back(constraint.size > 0.0 ? constraint.size : size);
}

}  // namespace tandem::mbs
