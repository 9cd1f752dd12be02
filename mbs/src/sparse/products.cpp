// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/sparse/products.hpp"

#include <algorithm>
#include <map>
#include <type_traits>

namespace tandem::mbs {

void multiply_transposed(const Pattern& a, const double* values, const double* x, double* y) {
  const int* const starts = a.starts().data();
  const int* const rows = a.indices().data();
  const int columns = a.columns();
  for (int c = 0; c < columns; ++c) {
    double sum = 0.0;
    for (int k = starts[c]; k < starts[c + 1]; ++k) sum += values[k] * x[rows[k]];
    y[c] = sum;
  }
}

void multiply_symmetric(const Matrix& a, const double* x, double* y) {
  multiply_transposed(a.pattern, a.values.data(), x, y);
}

void add_product(const Pattern& a, const double* values, const double* x, double* y) {
  const int* const starts = a.starts().data();
  const int* const rows = a.indices().data();
  const int columns = a.columns();
  for (int c = 0; c < columns; ++c)
    for (int k = starts[c]; k < starts[c + 1]; ++k) y[rows[k]] += values[k] * x[c];
}

namespace {

struct InRow {
  int column;
  std::int32_t position;
};

std::vector<std::vector<InRow>> by_row(const Pattern& a) {
  std::vector<std::vector<InRow>> rows(static_cast<std::size_t>(a.rows()));
  for (int c = 0; c < a.columns(); ++c)
    for (int k = a.starts()[c]; k < a.starts()[c + 1]; ++k) rows[a.indices()[k]].push_back({c, k});
  return rows;
}

}  // namespace

RankUpdate::RankUpdate(const Pattern& a, std::span<const std::pair<int, int>> target) : size_(target.size()) {
  const auto rows = by_row(a);
  std::map<std::size_t, std::pair<std::vector<std::int32_t>, std::vector<Factors>>> by_count;
  std::vector<Factors> products;
  for (std::size_t e = 0; e < target.size(); ++e) {
    const auto [row, column] = target[e];
    if (row < 0) continue;
    products.clear();
    auto right = rows[column].begin();
    for (const InRow& left : rows[row]) {
      while (right != rows[column].end() && right->column < left.column) ++right;
      if (right == rows[column].end()) break;
      if (right->column == left.column) products.push_back({left.position, right->position});
    }
    if (products.empty()) continue;
    auto& [entries, factors] = by_count[products.size()];
    entries.push_back(static_cast<std::int32_t>(e));
    factors.insert(factors.end(), products.begin(), products.end());
  }
  for (const auto& [count, group] : by_count) {
    groups_.push_back({count, group.first.size()});
    targets_.insert(targets_.end(), group.first.begin(), group.first.end());
    factors_.insert(factors_.end(), group.second.begin(), group.second.end());
  }
}

void RankUpdate::run(const double* a, double factor, const double* base, double* result) const {
  if (base != result) std::copy_n(base, size_, result);
  const std::int32_t* target = targets_.data();
  const Factors* factors = factors_.data();
  const auto add = [&](auto count, std::size_t entries) {
    for (std::size_t e = 0; e < entries; ++e, ++target) {
      double sum = 0.0;
      for (std::size_t k = 0; k < count; ++k, ++factors) sum += a[factors->left] * a[factors->right];
      result[*target] += factor * sum;
    }
  };
  for (const Group& group : groups_) switch (group.products) {
      case 1:
        add(std::integral_constant<std::size_t, 1>(), group.entries);
        break;
      case 2:
        add(std::integral_constant<std::size_t, 2>(), group.entries);
        break;
      case 3:
        add(std::integral_constant<std::size_t, 3>(), group.entries);
        break;
      case 4:
        add(std::integral_constant<std::size_t, 4>(), group.entries);
        break;
      default:
        add(group.products, group.entries);
    }
}

}  // namespace tandem::mbs
