// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "elimination.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace tandem::mbs::solvers {
namespace {

using Columns = std::vector<std::vector<int>>;  ///< of each place the rows below the diagonal, ascending

std::vector<int> inverse(const std::vector<int>& order) {
  std::vector<int> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<int>(k);
  return place;
}

Columns below_diagonal(const Pattern& pattern, const std::vector<int>& order) {
  const auto place = inverse(order);
  Columns columns(order.size());
  for (const auto& [row, column] : pattern.entries())
    if (place[row] > place[column]) columns[place[column]].push_back(place[row]);
  for (auto& rows : columns) std::sort(rows.begin(), rows.end());
  return columns;
}

/// Each column's rows join those of its parent, the first of them.
void fill(Columns& columns) {
  std::vector<int> both;
  for (const auto& rows : columns) {
    if (rows.empty()) continue;
    auto& parent = columns[rows.front()];
    both.clear();
    std::set_union(rows.begin() + 1, rows.end(), parent.begin(), parent.end(), std::back_inserter(both));
    parent = both;
  }
}

/// Children before their parents, and each subtree without a gap.
std::vector<int> postorder(const Columns& columns) {
  std::vector<std::vector<int>> children(columns.size() + 1);  // the last: of no parent
  for (std::size_t k = 0; k < columns.size(); ++k)
    children[columns[k].empty() ? columns.size() : columns[k].front()].push_back(static_cast<int>(k));
  std::vector<int> order, waiting = children.back();
  while (!waiting.empty()) {  // parents first, from the end
    const int node = waiting.back();
    waiting.pop_back();
    order.push_back(node);
    waiting.insert(waiting.end(), children[node].begin(), children[node].end());
  }
  std::reverse(order.begin(), order.end());
  return order;
}

std::vector<Supernode> supernodes_of(const Columns& columns, int most) {
  std::vector<Supernode> all;
  for (int k = 0; k < static_cast<int>(columns.size()); ++k) {
    const bool joins = k > 0 && !columns[k - 1].empty() && columns[k - 1].front() == k &&
                       columns[k - 1].size() == columns[k].size() + 1 && all.back().columns < most;
    if (!joins) all.push_back({k, 0, {}});
    ++all.back().columns;
    all.back().rows = columns[k];
  }
  return all;
}

}  // namespace

Elimination eliminate(const Pattern& pattern, const std::vector<int>& order, int most) {
  Columns columns = below_diagonal(pattern, order);
  fill(columns);
  Elimination elimination;
  for (const int place : postorder(columns)) elimination.order.push_back(order[place]);
  columns = below_diagonal(pattern, elimination.order);
  fill(columns);
  elimination.supernodes = supernodes_of(columns, most);
  return elimination;
}

double operations(const Elimination& elimination) {
  double sum = 0.0;
  for (const Supernode& s : elimination.supernodes)
    for (int k = 0; k < s.columns; ++k) {
      const double below = s.columns - 1.0 - k + static_cast<double>(s.rows.size());
      sum += 0.5 * below * (below + 3.0);
    }
  return sum;
}

}  // namespace tandem::mbs::solvers
