// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/sparse/products.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <map>
#include <type_traits>

namespace tandem::mbs {

namespace {

/// Calls run(entries, columns) for each run of columns, the number of entries known to the compiler if small.
template <class Run>
void for_runs(const Pattern& a, Run&& run) {
  for (const auto& [entries, columns] : a.runs()) switch (entries) {
      case 1:
        run(std::integral_constant<int, 1>(), columns);
        break;
      case 2:
        run(std::integral_constant<int, 2>(), columns);
        break;
      case 3:
        run(std::integral_constant<int, 3>(), columns);
        break;
      case 4:
        run(std::integral_constant<int, 4>(), columns);
        break;
      case 6:
        run(std::integral_constant<int, 6>(), columns);
        break;
      default:
        run(entries, columns);
    }
}

}  // namespace

void multiply_transposed(const Pattern& a, const double* values, const double* x, double* y) {
  const int* rows = a.indices().data();
  for_runs(a, [&](auto entries, int columns) {
    for (int c = 0; c < columns; ++c, values += entries, rows += entries) {
      double sum = entries > 0 ? values[0] * x[rows[0]] : 0.0;
      for (int k = 1; k < entries; ++k) sum += values[k] * x[rows[k]];
      *y++ = sum;
    }
  });
}

void multiply_symmetric(const Matrix& a, const double* x, double* y) {
  multiply_transposed(a.pattern, a.values.data(), x, y);
}

void add_product(const Pattern& a, const double* values, const double* x, double* y) {
  const int* rows = a.indices().data();
  for_runs(a, [&](auto entries, int columns) {
    for (int c = 0; c < columns; ++c, values += entries, rows += entries) {
      const double factor = *x++;
      for (int k = 0; k < entries; ++k) y[rows[k]] += values[k] * factor;
    }
  });
}

void add_scaled(std::size_t size, const double* a, double factor, const double* b, double* result) {
  for (std::size_t k = 0; k < size; ++k) result[k] = a[k] + factor * b[k];
}

namespace {

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

/// result[targets] += factor (a a^T) for columns of so many entries; entries: known to the compiler or not.
template <class Entries>
const std::int32_t* add_columns(Entries entries, std::span<const std::int32_t> starts, const double* a,
                                double factor, const std::int32_t* target, double* result) {
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
  return target;
}

}  // namespace

RankUpdate::RankUpdate(const Pattern& a, std::span<const std::pair<int, int>> target) : size_(target.size()) {
  const Lower lower(a.rows(), target);
  std::map<int, std::vector<int>> by_entries;
  for (int c = 0; c < a.columns(); ++c) by_entries[a.starts()[c + 1] - a.starts()[c]].push_back(c);
  for (const auto& [entries, columns] : by_entries) {
    groups_.push_back({static_cast<std::size_t>(entries), columns.size()});
    for (const int c : columns) {
      const auto rows =
          a.indices().subspan(static_cast<std::size_t>(a.starts()[c]), static_cast<std::size_t>(entries));
      starts_.push_back(a.starts()[c]);
      for (int i = 0; i < entries; ++i)
        for (int j = 0; j <= i; ++j) targets_.push_back(lower.first(rows[i], rows[j]));
    }
  }
  for (const auto& column : lower.columns())
    for (std::size_t k = 1, first = 0; k < column.size(); ++k)
      if (column[k].first == column[first].first)
        copies_.push_back({column[first].second, column[k].second});
      else
        first = k;
}

void RankUpdate::run(const double* a, double factor, const double* base, double* result) const {
  if (base != result) std::copy_n(base, size_, result);
  std::span<const std::int32_t> starts(starts_);
  const std::int32_t* target = targets_.data();
  for (const Group& group : groups_) {
    const auto add = [&](auto entries) {
      target = add_columns(entries, starts.first(group.columns), a, factor, target, result);
    };
    switch (group.entries) {
      case 1:
        add(std::integral_constant<std::size_t, 1>());
        break;
      case 2:
        add(std::integral_constant<std::size_t, 2>());
        break;
      case 3:
        add(std::integral_constant<std::size_t, 3>());
        break;
      case 4:
        add(std::integral_constant<std::size_t, 4>());
        break;
      case 6:
        add(std::integral_constant<std::size_t, 6>());
        break;
      default:
        add(group.entries);
    }
    starts = starts.subspan(group.columns);
  }
  for (const Copy& copy : copies_) result[copy.to] = result[copy.from];
}

}  // namespace tandem::mbs
