// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/sparse/products.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "small_count.hpp"
#include "team.hpp"

namespace tandem::mbs {
namespace {

template <int size>
using Together = Eigen::Matrix<double, size, 1>;
template <int size>
Eigen::Map<const Together<size>> at(const double* x) {
  return Eigen::Map<const Together<size>>(x);
}

template <int size, class Term>
Together<size> sum(int count, const Term& term) {
  Together<size> all = Together<size>::Zero();
  if (count > 0) all = term(0);
  for (int k = 1; k < count; ++k) all += term(k);
  return all;
}

/// body(groups, together): both known to the compiler, or the first is many.
template <class Body>
void with_groups(const Run& run, const Body& body) {
  with_count(run.groups, [&](auto groups) {
    if (run.together == 1) body(groups, std::integral_constant<int, 1>());
    if (run.together == 2) body(groups, std::integral_constant<int, 2>());
    if (run.together == 3) body(groups, std::integral_constant<int, 3>());
  });
}

/// body(groups, together, part): of each run what a thread has of it.
template <class Body>
void for_runs(std::span<const Run> runs, const Body& body) {
  if (runs.empty()) return;
  share(runs.back().unit + runs.back().units, [&](int first, int last) {
    for (const Run& run : runs) {
      const int from = std::max(first - run.unit, 0), to = std::min(last - run.unit, run.units);
      if (from >= to) continue;
      const Run part{run.groups,
                     run.together,
                     to - from,
                     run.unit + from,
                     run.row + from * run.together,
                     run.group + from * run.groups,
                     run.value + from * run.groups * run.together};
      with_groups(run, [&](auto groups, auto together) { body(groups, together, part); });
    }
  });
}

/// Columns of so many groups: of each the dot product with x.
template <int together, class Groups>
void multiply_columns(Groups groups, int columns, const int* row, const double* value, const double* x,
                      double* y) {
  for (const double* const end = y + columns; y < end; ++y) {
    const auto product = [=](int k) {
      return at<together>(value + k * together).cwiseProduct(at<together>(x + row[k * together]));
    };
    *y = sum<together>(groups, product).sum();
    row += groups * together, value += groups * together;
  }
}

/// Blocks of rows of so many groups.
template <int together, class Groups, class Entry>
void multiply_rows(Groups groups, int blocks, const Entry* entry, const double* values, const double* x,
                   double* y) {
  for (const double* const end = y + blocks * together; y < end; y += together) {
    const auto product = [=](int k) { return x[entry[k].column] * at<together>(values + entry[k].position); };
    Eigen::Map<Together<together>>{y} = sum<together>(groups, product);
    entry += groups;
  }
}

}  // namespace

void multiply_transposed(const Pattern& a, const double* values, const double* x, double* y) {
  for_runs(a.runs(), [=, rows = a.indices().data()](auto groups, auto together, const Run& part) {
    multiply_columns<together>(groups, part.units, rows + part.value, values + part.value, x, y + part.unit);
  });
}

void multiply_symmetric(const Matrix& a, const double* x, double* y) {
  multiply_transposed(a.pattern, a.values.data(), x, y);
}

/// Rows that have entries in the same columns come in blocks of two or three, if they come out even.
Rows::Rows(const Pattern& a) {
  std::vector<std::vector<int>> columns(static_cast<std::size_t>(a.rows()));
  for (const auto& [row, column] : a.entries()) columns[static_cast<std::size_t>(row)].push_back(column);
  for (auto first = columns.begin(); first != columns.end();) {
    const auto last = std::find_if(first, columns.end(), [&](const auto& other) { return other != *first; });
    const int alike = static_cast<int>(last - first), together = alike % 2 == 0 ? 2 : alike % 3 == 0 ? 3 : 1;
    for (; first != last; first += together)
      add(a, static_cast<int>(first - columns.begin()), *first, together);
  }
}

void Rows::add(const Pattern& a, int row, const std::vector<int>& columns, int together) {
  for (const int column : columns) entries_.push_back({a.find(row, column), column});
  append(runs_, static_cast<int>(columns.size()), together);
}

void Rows::multiply(const double* values, const double* x, double* y) const {
  for_runs(runs_, [=, entries = entries_.data()](auto groups, auto together, const Run& part) {
    multiply_rows<together>(groups, part.units, entries + part.group, values, x, y + part.row);
  });
}

ColumnSquares column_squares(const Pattern& a, const double* values) {
  ColumnSquares found{HUGE_VAL, 0.0};
  for (const auto& run : a.runs())
    with_groups(run, [&](auto groups, auto together) {
      for (int c = 0; c < run.units; ++c, values += groups * together) {
        const auto square = [=](int k) { return at<together>(values + k * together).cwiseAbs2(); };
        const double all = sum<together>(groups, square).sum();
        found = {std::min(found.least, all), std::max(found.most, all)};
      }
    });
  return found;
}

void add_scaled(std::size_t size, const double* a, double factor, const double* b, double* result) {
  for (std::size_t k = 0; k < size; ++k) result[k] = a[k] + factor * b[k];
}

}  // namespace tandem::mbs
