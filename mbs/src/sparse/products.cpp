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

/// body(groups, together): the groups of a column and their size, known to the compiler, or the first is
/// many.
template <class Body>
void with_groups(const Pattern::Run& run, const Body& body) {
  with_count(run.entries / run.together, [&](auto groups) {
    if (run.together == 1) body(groups, std::integral_constant<int, 1>());
    if (run.together == 2) body(groups, std::integral_constant<int, 2>());
    if (run.together == 3) body(groups, std::integral_constant<int, 3>());
  });
}

/// Of a run the part that a thread has, by what comes before it in all runs.
struct Part {
  int unit, count;  ///< units: what share() counts
  int group, value, row;
};

/// body(groups, together, part) for runs of `units` in all.
template <class Body>
void for_runs(std::span<const Pattern::Run> runs, int units, const Body& body) {
  share(units, [&](int first, int last) {
    Part before{};
    for (const Pattern::Run& run : runs) {
      const int from = std::max(first - before.unit, 0), to = std::min(last - before.unit, run.columns);
      const auto after = [&](int n) {
        return Part{before.unit + n, to - n, before.group + n * (run.entries / run.together),
                    before.value + n * run.entries, before.row + n * run.together};
      };
      if (from < to)
        with_groups(run, [&](auto groups, auto together) { body(groups, together, after(from)); });
      before = after(run.columns);
    }
  });
}

}  // namespace

void multiply_transposed(const Pattern& a, const double* values, const double* x, double* y) {
  for_runs(a.runs(), a.columns(), [&](auto groups, auto together, const Part& part) {
    const int* row = a.indices().data() + part.value;
    const double* value = values + part.value;
    for (int c = part.unit, end = c + part.count; c < end; ++c) {
      const auto product = [=](int k) {
        return at<together>(value + k * together).cwiseProduct(at<together>(x + row[k * together]));
      };
      y[c] = sum<together>(groups, product).sum();
      row += groups * together, value += groups * together;
    }
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
  const Pattern::Run run{together * static_cast<int>(columns.size()), 1, together};
  if (runs_.empty() || runs_.back().entries != run.entries || runs_.back().together != together)
    runs_.push_back(run);
  else
    ++runs_.back().columns;
  ++blocks_;
}

void Rows::multiply(const double* values, const double* x, double* y) const {
  for_runs(runs_, blocks_, [&](auto groups, auto together, const Part& part) {
    const Entry* entry = entries_.data() + part.group;
    for (double *to = y + part.row, *end = to + part.count * together; to < end; to += together) {
      Eigen::Map<Together<together>> rows(to);
      rows = sum<together>(
          groups, [&](int k) { return x[entry[k].column] * at<together>(values + entry[k].position); });
      entry += groups;
    }
  });
}

ColumnSquares column_squares(const Pattern& a, const double* values) {
  ColumnSquares found{HUGE_VAL, 0.0};
  for (const auto& run : a.runs())
    with_groups(run, [&](auto groups, auto together) {
      for (int c = 0; c < run.columns; ++c, values += groups * together) {
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
