// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/numbering.hpp"

#include <array>

namespace tandem::mbs {

Numbering::Numbering(const Description& in) : entity(in.entities.size()), relative(in.relatives.size()) {
  constexpr std::array axis = {"x", "y", "z"};
  int next = 0;
  const auto number = [&](bool fixed) {
    for (std::size_t i = 0; i < entity.size(); ++i) {
      if (in.entities[i].fixed != fixed) continue;
      entity[i] = next;
      next += in.dimension;
      for (int k = 0; k < in.dimension && !fixed; ++k)
        variable_names.push_back(in.entities[i].name + "." + axis.at(k));
    }
  };
  number(false);
  for (std::size_t i = 0; i < relative.size(); ++i) {
    relative[i] = next++;
    variable_names.push_back(in.relatives[i].name);
  }
  variables = next;
  number(true);
  zero = next;
  coordinates = next + in.dimension;
}

}  // namespace tandem::mbs
