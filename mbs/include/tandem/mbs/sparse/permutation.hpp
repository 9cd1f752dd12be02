// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>
#include <vector>

#include "tandem/mbs/sparse/pattern.hpp"

namespace tandem::mbs {

/// y[k] = x[from[k]]. x and y are different arrays.
inline void gather(std::span<const int> from, const double* x, double* y) {
  for (std::size_t k = 0; k < from.size(); ++k) y[k] = x[from[k]];
}

/// y[to[k]] = x[k]. x and y are different arrays.
inline void scatter(std::span<const int> to, const double* x, double* y) {
  for (std::size_t k = 0; k < to.size(); ++k) y[to[k]] = x[k];
}

/// P A P^T prepared: its pattern, and by position of its values that in A, for gather().
struct Permuted {
  Pattern pattern;
  std::vector<int> from;
};

/// order: by place in P A P^T the row and column of A that stands there. Precondition: A is square.
Permuted permuted(const Pattern& a, std::span<const int> order);

}  // namespace tandem::mbs
