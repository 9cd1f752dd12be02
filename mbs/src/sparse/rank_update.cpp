// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/sparse/rank_update.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <map>
#include <tuple>

#include "block_products.hpp"
#include "team.hpp"

namespace tandem::mbs {
namespace {

constexpr int worth_colouring = 4000;  ///< columns: sums stand in another order with colours

using Target = std::vector<std::pair<int, int>>;

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

/// By (row, column) the positions of a layout that hold it.
class Positions {
 public:
  Positions(int columns, const Target& target) : columns_(static_cast<std::size_t>(columns)) {
    for (std::size_t e = 0; e < target.size(); ++e)
      if (const auto [row, column] = target[e]; row >= 0)
        columns_[column].push_back({row, static_cast<std::int32_t>(e)});
    for (auto& column : columns_) std::sort(column.begin(), column.end());
  }
  /// -1: none.
  std::int32_t first(int row, int column) const {
    const auto& entries = columns_[column];
    const auto at = std::lower_bound(entries.begin(), entries.end(), std::pair(row, 0));
    return at != entries.end() && at->first == row ? at->second : -1;
  }
  /// Whether A A^T is there as a whole, both triangles.
  bool have_all(const Pattern& a) const {
    for (int c = 0; c < a.columns(); ++c)
      for (const int row : rows_of(a, c))
        for (const int column : rows_of(a, c))
          if (first(row, column) < 0) return false;
    return true;
  }
  const auto& columns() const { return columns_; }

 private:
  std::vector<std::vector<std::pair<int, std::int32_t>>> columns_;  ///< (row, position), sorted
};

Target lower(Target target) {
  for (auto& [row, column] : target)
    if (row < column) std::swap(row, column);
  return target;
}

/// Where add_products() puts the blocks of a column of A with these rows; none if the rows of a block do not
/// stand together there.
std::vector<std::int32_t> block_targets(const Positions& positions, std::span<const int> rows, bool both,
                                        std::size_t together) {
  std::vector<std::int32_t> all;
  bool stand = rows.size() % together == 0;
  const auto add = [&](std::span<const int> block, int column) {
    all.push_back(positions.first(block[0], column));
    assert(all.back() >= 0);
    for (std::size_t i = 1; i < block.size(); ++i)
      stand = stand && positions.first(block[i], column) == all.back() + static_cast<int>(i);
  };
  for (std::size_t q = 0; stand && q < rows.size(); q += together)
    for (std::size_t p = q; p < rows.size(); p += together) {
      for (std::size_t d = 0; d < together; ++d) {
        const std::size_t above = p == q && !both ? d : 0;
        add(rows.subspan(p + above, together - above), rows[q + d]);
      }
      for (std::size_t d = 0; both && p > q && d < together; ++d) add(rows.subspan(q, together), rows[p + d]);
    }
  return stand ? all : std::vector<std::int32_t>();
}

/// Whether points have two coordinates rather than three: pairs of other rows would be stored one way and
/// loaded another, which waits.
bool are_planar(const Pattern& a) {
  int pairs = 0, triples = 0;
  for (int c = 0; c < a.columns(); ++c) {
    pairs += rows_of(a, c).size() % 2 == 0;
    triples += rows_of(a, c).size() % 3 == 0;
  }
  return pairs >= triples;
}

/// (from, to): entries that a layout names again.
std::vector<std::pair<std::int32_t, std::int32_t>> repeated(const Positions& positions) {
  std::vector<std::pair<std::int32_t, std::int32_t>> all;
  for (const auto& column : positions.columns())
    for (std::size_t k = 1, first = 0; k < column.size(); ++k)
      if (column[k].first == column[first].first)
        all.emplace_back(column[first].second, column[k].second);
      else
        first = k;
  return all;
}

}  // namespace

RankUpdate::RankUpdate(const Pattern& a, std::span<const std::pair<int, int>> layout)
    : size_(layout.size()), coloured_(a.columns() >= worth_colouring) {
  const Target target(layout.begin(), layout.end());
  Positions positions(a.rows(), target);
  both_ = positions.have_all(a);
  if (!both_) positions = Positions(a.rows(), lower(target));
  copies_ = repeated(positions);
  const auto colour = coloured_ ? colours(a) : std::vector<int>(a.columns());
  const bool planar = are_planar(a);
  std::map<std::tuple<int, int, int>, Group> groups;
  for (int c = 0; c < a.columns(); ++c) {
    const auto rows = rows_of(a, c);
    auto targets = planar ? block_targets(positions, rows, both_, 2) : std::vector<std::int32_t>();
    const int together = targets.empty() ? 1 : 2, blocks = static_cast<int>(rows.size()) / together;
    if (together == 1) targets = block_targets(positions, rows, both_, 1);
    Group& group = groups[{blocks, together, colour[c]}];
    group.blocks = blocks, group.together = together;
    group.starts.push_back(a.starts()[c]);
    group.targets.insert(group.targets.end(), targets.begin(), targets.end());
  }
  for (auto& [kind, group] : groups) groups_.push_back(std::move(group));
}

void RankUpdate::run(const double* a, double factor, const double* base, double* result) const {
  if (base != result)
    share(static_cast<int>(size_),
          [=](int first, int last) { std::copy(base + first, base + last, result + first); });
  for (const Group& group : groups_) {
    const int blocks = both_ ? group.blocks * group.blocks : group.blocks * (group.blocks + 1) / 2;
    const auto add_columns = [&](int first, int last) {
      const std::span starts(group.starts.data() + first, group.starts.data() + last);
      const BlockSum sum{result, group.targets.data() + std::ptrdiff_t{first} * blocks * group.together};
      with_count(group.blocks, [&](auto count) {
        if (both_ && group.together == 1) add_products<true, 1>(count, starts, a, factor, sum);
        if (both_ && group.together == 2) add_products<true, 2>(count, starts, a, factor, sum);
        if (!both_ && group.together == 1) add_products<false, 1>(count, starts, a, factor, sum);
        if (!both_ && group.together == 2) add_products<false, 2>(count, starts, a, factor, sum);
      });
    };
    const int columns = static_cast<int>(group.starts.size());
    coloured_ ? share(columns, add_columns) : add_columns(0, columns);
  }
  for (const auto& [from, to] : copies_) result[to] = base[to] + (result[from] - base[from]);
}

}  // namespace tandem::mbs
