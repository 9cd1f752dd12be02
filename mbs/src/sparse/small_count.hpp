// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <type_traits>

namespace tandem::mbs {

/// run(count), the counts that are frequent in mechanisms known to the compiler.
template <class Count, class Run>
void with_count(Count count, const Run& run) {
  switch (count) {
    case 1:
      return run(std::integral_constant<Count, 1>());
    case 2:
      return run(std::integral_constant<Count, 2>());
    case 3:
      return run(std::integral_constant<Count, 3>());
    case 4:
      return run(std::integral_constant<Count, 4>());
    case 6:
      return run(std::integral_constant<Count, 6>());
    default:
      return run(count);
  }
}

}  // namespace tandem::mbs
