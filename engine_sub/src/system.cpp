// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/engine/system.hpp"

namespace tandem::engine {

double System::watched(int crossing) const {
  return image_[static_cast<std::size_t>(program_.crossings[static_cast<std::size_t>(crossing)].signal)];
}

int System::changed(int first) const {
  for (auto k = static_cast<std::size_t>(first); k < program_.crossings.size(); ++k) {
    const Crossing& c = program_.crossings[k];
    if (image_[static_cast<std::size_t>(c.signal)] * image_[static_cast<std::size_t>(c.sign)] < 0.0)
      return static_cast<int>(k);
  }
  return -1;
}

}  // namespace tandem::engine
