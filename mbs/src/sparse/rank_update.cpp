// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/sparse/rank_update.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <map>

#include "small_count.hpp"
#include "team.hpp"

namespace tandem::mbs {
namespace {

constexpr int worth_colouring = 4000;  ///< columns: sums stand in another order with colours

/// By (row, column) below the diagonal the positions of a layout that hold it.
class Lower {
 public:
  Lower(int columns, std::span<const std::pair<int, int>> target)
      : columns_(static_cast<std::size_t>(columns)) {
    for (std::size_t e = 0; e < target.size(); ++e)
      if (const auto [low, high] = std::minmax(target[e].first, target[e].second); low >= 0)
        columns_[low].push_back({high, static_cast<std::int32_t>(e)});
    for (auto& column : columns_) std::sort(column.begin(), column.end());
  }
  std::int32_t first(int row, int column) const {
    const auto& entries = columns_[std::min(row, column)];
    const auto at = std::lower_bound(entries.begin(), entries.end(), std::pair(std::max(row, column), 0));
    assert(at != entries.end() && at->first == std::max(row, column));
    return at->second;
  }
  const auto& columns() const { return columns_; }

 private:
  std::vector<std::vector<std::pair<int, std::int32_t>>> columns_;  ///< (row, position), sorted
};

std::span<const int> rows_of(const Pattern& a, int column) {
  const auto starts = a.starts();
  return a.indices().subspan(starts[column], starts[column + 1] - starts[column]);
}

/// Each column gets the first colour that no column before it has in one of its rows.
std::vector<int> colours(const Pattern& a) {
  std::vector<int> of(a.columns());
  std::vector<std::vector<bool>> taken(a.rows());
  for (int c = 0; c < a.columns(); ++c) {
    const auto rows = rows_of(a, c);
    const auto is_taken = [&](int row) {
      return static_cast<int>(taken[row].size()) > of[c] && taken[row][of[c]];
    };
    while (std::any_of(rows.begin(), rows.end(), is_taken)) ++of[c];
    for (const int row : rows) {
      taken[row].resize(std::max<std::size_t>(taken[row].size(), of[c] + 1));
      taken[row][of[c]] = true;
    }
  }
  return of;
}

}  // namespace

RankUpdate::RankUpdate(const Pattern& a, std::span<const std::pair<int, int>> target)
    : size_(target.size()), coloured_(a.columns() >= worth_colouring) {
  const Lower lower(a.rows(), target);
  const auto colour = coloured_ ? colours(a) : std::vector<int>(a.columns());
  std::map<std::pair<std::size_t, int>, std::vector<int>> groups;
  for (int c = 0; c < a.columns(); ++c) groups[{rows_of(a, c).size(), colour[c]}].push_back(c);
  for (const auto& [kind, columns] : groups) {
    groups_.push_back({kind.first, static_cast<int>(columns.size())});
    for (const int c : columns) {
      const auto rows = rows_of(a, c);
      starts_.push_back(a.starts()[c]);
      for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j) targets_.push_back(lower.first(rows[i], rows[j]));
    }
  }
  for (const auto& column : lower.columns())
    for (std::size_t k = 1, first = 0; k < column.size(); ++k)
      if (column[k].first == column[first].first)
        copies_.push_back({column[first].second, column[k].second});
      else
        first = k;
}

/// result[targets] += factor (a a^T) for columns of so many entries; entries: known to the compiler or not.
template <class Entries>
void RankUpdate::add(Entries entries, std::span<const std::int32_t> starts, const std::int32_t* target,
                     const double* a, double factor, double* result) {
  constexpr std::size_t most = 8;
  for (const std::int32_t start : starts) {
    const double* column = a + start;
    std::array<double, most> local;
    if constexpr (!std::is_integral_v<Entries>) {  // or they would be read again after each store
      for (std::size_t k = 0; k < entries; ++k) local[k] = column[k];
      column = local.data();
    }
    for (std::size_t i = 0; i < entries; ++i) {
      const double scaled = factor * column[i];
      for (std::size_t j = 0; j <= i; ++j) result[*target++] += scaled * column[j];
    }
  }
}

void RankUpdate::run(const double* a, double factor, const double* base, double* result) const {
  if (base != result)
    share(static_cast<int>(size_),
          [=](int first, int last) { std::copy(base + first, base + last, result + first); });
  const std::int32_t *start = starts_.data(), *target = targets_.data();
  for (const Group& group : groups_) {
    const std::size_t products = group.entries * (group.entries + 1) / 2;
    const auto add_columns = [=](int first, int last) {
      with_count(group.entries, [=](auto entries) {
        add(entries, {start + first, start + last}, target + products * first, a, factor, result);
      });
    };
    coloured_ ? share(group.columns, add_columns) : add_columns(0, group.columns);
    start += group.columns;
    target += products * group.columns;
  }
  for (const auto& [from, to] : copies_) result[to] = base[to] + (result[from] - base[from]);
}

}  // namespace tandem::mbs
