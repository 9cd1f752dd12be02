// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/sparse/pattern.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <tuple>

namespace tandem::mbs {
namespace {

/// As Pattern::Run::together, of one column.
int together(std::span<const int> rows) {
  const auto stand = [&](std::size_t size) {
    bool all = !rows.empty() && rows.size() % size == 0;
    for (std::size_t k = 0; all && k < rows.size(); k += size)
      all = rows[k + size - 1] - rows[k] == static_cast<int>(size) - 1;
    return all;
  };
  return stand(2) ? 2 : stand(3) ? 3 : 1;
}

}  // namespace

Pattern::Pattern(int rows, int columns, std::vector<std::pair<int, int>> entries) : rows_(rows) {
  const auto by_column = [](const auto& a, const auto& b) {
    return std::pair(a.second, a.first) < std::pair(b.second, b.first);
  };
  std::sort(entries.begin(), entries.end(), by_column);
  entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
  starts_.assign(static_cast<std::size_t>(columns) + 1, 0);
  for (const auto& [row, column] : entries) {
    assert(row >= 0 && row < rows && column >= 0 && column < columns);
    indices_.push_back(row);
    ++starts_[static_cast<std::size_t>(column) + 1];
  }
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  add_runs();
}

void Pattern::add_runs() {
  const auto rows = [&](int c) { return indices().subspan(starts_[c], starts_[c + 1] - starts_[c]); };
  const auto follows = [&](int c) {
    return std::equal(rows(c).begin(), rows(c).end(), rows(c - 1).begin(), rows(c - 1).end(),
                      [](int row, int before) { return row == before + 1; });
  };
  for (int c = 0, next = 1; c < columns(); c = next++) {
    const int entries = static_cast<int>(rows(c).size()), size = together(rows(c));
    while (size == 1 && entries > 0 && next < columns() && follows(next)) ++next;
    append(runs_, {c, next - c, starts_[c], entries / size, size, size == 1 ? in_step(next - c) : 1});
  }
}

void append(std::vector<Pattern::Run>& runs, const Pattern::Run& next) {
  const auto kind = [](const Pattern::Run& r) { return std::tuple(r.groups, r.together, r.abreast); };
  if (runs.empty() || kind(runs.back()) != kind(next))
    runs.push_back(next);
  else
    runs.back().columns += next.columns;
}

int Pattern::find(int row, int column) const {
  const auto begin = indices_.begin() + starts_[static_cast<std::size_t>(column)];
  const auto end = indices_.begin() + starts_[static_cast<std::size_t>(column) + 1];
  const auto at = std::lower_bound(begin, end, row);
  return at != end && *at == row ? static_cast<int>(at - indices_.begin()) : -1;
}

std::vector<std::pair<int, int>> Pattern::entries() const {
  std::vector<std::pair<int, int>> all;
  all.reserve(indices_.size());
  for (int column = 0; column < columns(); ++column)
    for (int k = starts_[static_cast<std::size_t>(column)]; k < starts_[static_cast<std::size_t>(column) + 1];
         ++k)
      all.emplace_back(indices_[static_cast<std::size_t>(k)], column);
  return all;
}

Pattern Pattern::lower() const {
  auto all = entries();
  std::erase_if(all, [](const auto& entry) { return entry.first < entry.second; });
  return {rows_, columns(), std::move(all)};
}

Pattern unite(const Pattern& a, const Pattern& b) {
  assert(a.rows() == b.rows() && a.columns() == b.columns());
  auto all = a.entries();
  const auto more = b.entries();
  all.insert(all.end(), more.begin(), more.end());
  return {a.rows(), a.columns(), std::move(all)};
}

std::vector<int> positions(const Pattern& part, const Pattern& whole) {
  std::vector<int> found;
  for (const auto& [row, column] : part.entries()) found.push_back(whole.find(row, column));
  return found;
}

}  // namespace tandem::mbs
