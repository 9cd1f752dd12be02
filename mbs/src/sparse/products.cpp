// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/sparse/products.hpp"

#include <algorithm>

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

RankUpdate::RankUpdate(const Pattern& a, const Pattern& target) {
  std::vector<std::vector<Factors>> lists(static_cast<std::size_t>(target.size()));
  for (int c = 0; c < a.columns(); ++c)
    for (int left = a.starts()[c]; left < a.starts()[c + 1]; ++left)
      for (int right = a.starts()[c]; right < a.starts()[c + 1]; ++right)
        if (const int entry = target.find(a.indices()[left], a.indices()[right]); entry >= 0)
          lists[entry].push_back({left, right});
  starts_.push_back(0);
  for (const auto& list : lists) {
    factors_.insert(factors_.end(), list.begin(), list.end());
    starts_.push_back(static_cast<std::int32_t>(factors_.size()));
  }
}

void RankUpdate::run(const double* a, double factor, const double* base, double* result) const {
  const std::int32_t* const starts = starts_.data();
  const Factors* const factors = factors_.data();
  const auto entries = starts_.size() - 1;
  for (std::size_t e = 0; e < entries; ++e) {
    double sum = 0.0;
    for (std::int32_t k = starts[e]; k < starts[e + 1]; ++k) sum += a[factors[k].left] * a[factors[k].right];
    result[e] = base[e] + factor * sum;
  }
}

}  // namespace tandem::mbs
