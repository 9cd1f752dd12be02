// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/sparse/products.hpp"

#include <algorithm>
#include <cmath>

#include "small_count.hpp"
#include "team.hpp"

namespace tandem::mbs {
namespace {

/// run(entries, first, last) for runs of columns, shared by threads; entries: known to the compiler or not.
template <class Run>
void for_runs(const Pattern& a, const Run& run) {
  share(a.columns(), [&](int first, int last) {
    int begin = 0;
    for (const auto& [entries, columns] : a.runs()) {
      const int from = std::max(first, begin), to = std::min(last, begin += columns);
      if (from < to) with_count(entries, [&](auto count) { run(count, from, to); });
    }
  });
}

}  // namespace

void multiply_transposed(const Pattern& a, const double* values, const double* x, double* y) {
  for_runs(a, [&](auto entries, int first, int last) {
    const int* row = a.indices().data() + a.starts()[first];
    const double* value = values + a.starts()[first];
    for (int c = first; c < last; ++c, value += entries, row += entries) {
      double sum = entries > 0 ? value[0] * x[row[0]] : 0.0;
      for (int k = 1; k < entries; ++k) sum += value[k] * x[row[k]];
      y[c] = sum;
    }
  });
}

void multiply_symmetric(const Matrix& a, const double* x, double* y) {
  multiply_transposed(a.pattern, a.values.data(), x, y);
}

Rows::Rows(const Pattern& a) {
  std::vector<std::pair<int, int>> entries = a.entries();
  for (auto& [row, column] : entries) std::swap(row, column);
  transposed_ = Pattern(a.columns(), a.rows(), entries);
  for (const auto& [column, row] : transposed_.entries()) entries_.push_back({a.find(row, column), column});
}

void Rows::multiply(const double* values, const double* x, double* y) const {
  for_runs(transposed_, [&](auto count, int first, int last) {
    const Entry* entry = entries_.data() + transposed_.starts()[first];
    for (int r = first; r < last; ++r, entry += count) {
      double sum = count > 0 ? values[entry[0].position] * x[entry[0].column] : 0.0;
      for (int k = 1; k < count; ++k) sum += values[entry[k].position] * x[entry[k].column];
      y[r] = sum;
    }
  });
}

ColumnSquares column_squares(const Pattern& a, const double* values) {
  ColumnSquares found{HUGE_VAL, 0.0};
  for (const auto& [entries, columns] : a.runs())
    with_count(entries, [&, columns = columns](auto count) {
      for (int c = 0; c < columns; ++c, values += count) {
        double sum = count > 0 ? values[0] * values[0] : 0.0;
        for (int k = 1; k < count; ++k) sum += values[k] * values[k];
        found = {std::min(found.least, sum), std::max(found.most, sum)};
      }
    });
  return found;
}

void add_scaled(std::size_t size, const double* a, double factor, const double* b, double* result) {
  for (std::size_t k = 0; k < size; ++k) result[k] = a[k] + factor * b[k];
}

}  // namespace tandem::mbs
