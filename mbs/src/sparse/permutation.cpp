// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/sparse/permutation.hpp"

#include <cassert>

namespace tandem::mbs {

Permuted permuted(const Pattern& a, std::span<const int> order) {
  assert(a.rows() == a.columns() && static_cast<std::size_t>(a.rows()) == order.size());
  std::vector<int> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<int>(k);
  std::vector<std::pair<int, int>> entries;
  for (const auto& [row, column] : a.entries()) entries.emplace_back(place[row], place[column]);
  Permuted result{Pattern(a.rows(), a.columns(), std::move(entries)), {}};
  for (const auto& [row, column] : result.pattern.entries())
    result.from.push_back(a.find(order[row], order[column]));
  return result;
}

}  // namespace tandem::mbs
