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

/// Numbers so far apart.
template <int size, class Distance>
auto across(const double* x, Distance distance) {
  constexpr int known = std::is_integral_v<Distance> ? Eigen::Dynamic : static_cast<int>(Distance());
  return Eigen::Map<const Together<size>, 0, Eigen::InnerStride<known>>(x,
                                                                        Eigen::InnerStride<known>(distance));
}

template <int size, class Term>
Together<size> sum(int count, const Term& term) {
  Together<size> all = Together<size>::Zero();
  if (count > 0) all = term(0);
  for (int k = 1; k < count; ++k) all += term(k);
  return all;
}

/// Of a run the part within first .. last, counted from its begin, in whole blocks of `size`.
std::pair<int, int> part(const Pattern::Run& run, int size, int first, int last) {
  const auto up = [=](int n) { return (n + size - 1) / size * size; };
  const int from = first - run.first, to = last - run.first;
  return {from <= 0 ? 0 : std::min(up(from), run.columns),
          to >= run.columns ? run.columns : std::max(up(to), 0)};
}

/// y = a dot product with x for each column of so many groups of `together` rows. What functions like this
/// one take is in registers: parts of a lambda's captures would be stored, and waited for.
template <int together, class Groups>
void multiply_each(Groups groups, const int* row, const double* value, const double* x, std::span<double> y) {
  for (double& product : y) {
    const auto term = [=](std::ptrdiff_t k) {
      return at<together>(value + k * together).cwiseProduct(at<together>(x + row[k * together]));
    };
    product = sum<together>(groups, term).sum();
    row += groups * together, value += groups * together;
  }
}

/// The same for columns of so many entries, `abreast` at a time.
template <int abreast, class Entries>
void multiply_abreast(Entries entries, const int* row, const double* value, const double* x,
                      std::span<double> y) {
  for (double *to = y.data(), *end = to + y.size(); to < end; to += abreast) {
    const auto term = [=](int k) {
      return across<abreast>(value + k, entries).cwiseProduct(at<abreast>(x + row[k]));
    };
    Eigen::Map<Together<abreast>>{to} = sum<abreast>(entries, term);
    row += entries * abreast, value += entries * abreast;
  }
}

struct Columns {
  int first, last;
};

void multiply_columns(const Pattern& a, const double* values, const double* x, double* y, Columns columns) {
  for (const Pattern::Run& run : a.runs()) {
    const auto [from, to] = part(run, run.abreast, columns.first, columns.last);
    const int start = a.starts()[run.first + from];
    const int* const row = a.indices().data() + start;
    const double* const value = values + start;
    const std::span<double> result(y + run.first + from, y + run.first + to);
    with_count(run.groups, [=](auto groups) {
      if (run.together == 1 && run.abreast == 1) multiply_each<1>(groups, row, value, x, result);
      if (run.together == 2) multiply_each<2>(groups, row, value, x, result);
      if (run.together == 3) multiply_each<3>(groups, row, value, x, result);
      if (run.abreast == 2) multiply_abreast<2>(groups, row, value, x, result);
      if (run.abreast == 3) multiply_abreast<3>(groups, row, value, x, result);
    });
  }
}

/// y = so many rows at a time, with entries in so many columns.
template <int together, class Groups, class Entry>
void multiply_blocks(Groups groups, const Entry* entry, const double* values, const double* x,
                     std::span<double> y) {
  for (double *to = y.data(), *end = to + y.size(); to < end; to += together) {
    const auto term = [=](int k) -> Together<together> {
      return x[entry[k].column] * at<together>(values + entry[k].position);
    };
    Eigen::Map<Together<together>>{to} = sum<together>(groups, term);
    entry += groups;
  }
}

}  // namespace

void multiply_transposed(const Pattern& a, const double* values, const double* x, double* y) {
  share(a.columns(), [=, &a](int first, int last) { multiply_columns(a, values, x, y, {first, last}); });
}

void multiply_symmetric(const Matrix& a, const double* x, double* y) {
  multiply_transposed(a.pattern, a.values.data(), x, y);
}

/// Rows that have entries in the same columns come in blocks of two or three, if they come out even.
Rows::Rows(const Pattern& a) : rows_(a.rows()) {
  std::vector<std::vector<int>> columns(static_cast<std::size_t>(a.rows()));
  for (const auto& [row, column] : a.entries()) columns[static_cast<std::size_t>(row)].push_back(column);
  for (auto first = columns.begin(); first != columns.end();) {
    const auto last = std::find_if(first, columns.end(), [&](const auto& other) { return other != *first; });
    const int together = in_step(static_cast<int>(last - first));
    for (; first != last; first += together)
      add(a, static_cast<int>(first - columns.begin()), *first, together);
  }
}

void Rows::add(const Pattern& a, int row, const std::vector<int>& columns, int together) {
  const int start = static_cast<int>(entries_.size()), groups = static_cast<int>(columns.size());
  append(runs_, {row, together, start, groups, together, 1});
  for (const int column : columns) entries_.push_back({a.find(row, column), column});
}

void Rows::multiply(const double* values, const double* x, double* y) const {
  share(rows_, [=, this](int first, int last) { multiply(values, x, y, first, last); });
}

void Rows::multiply(const double* values, const double* x, double* y, int first, int last) const {
  for (const auto& run : runs_) {
    const auto [from, to] = part(run, run.together, first, last);
    const Entry* const entry =
        entries_.data() + run.start + (from == 0 ? 0 : from / run.together * run.groups);
    const std::span<double> result(y + run.first + from, y + run.first + to);
    with_count(run.groups, [=](auto groups) {
      if (run.together == 1) multiply_blocks<1>(groups, entry, values, x, result);
      if (run.together == 2) multiply_blocks<2>(groups, entry, values, x, result);
      if (run.together == 3) multiply_blocks<3>(groups, entry, values, x, result);
    });
  }
}

ColumnSquares column_squares(const Pattern& a, const double* values) {
  ColumnSquares found{HUGE_VAL, 0.0};
  const auto take = [&](const Pattern::Run& run, auto groups, auto together) {
    for (int c = 0; c < run.columns; ++c, values += groups * together) {
      const auto square = [=](int k) { return at<together>(values + k * together).cwiseAbs2(); };
      const double all = sum<together>(groups, square).sum();
      found = {std::min(found.least, all), std::max(found.most, all)};
    }
  };
  for (const auto& run : a.runs())
    with_count(run.groups, [&](auto groups) {
      if (run.together == 1) take(run, groups, std::integral_constant<int, 1>());
      if (run.together == 2) take(run, groups, std::integral_constant<int, 2>());
      if (run.together == 3) take(run, groups, std::integral_constant<int, 3>());
    });
  return found;
}

void add_scaled(std::size_t size, const double* a, double factor, const double* b, double* result) {
  for (std::size_t k = 0; k < size; ++k) result[k] = a[k] + factor * b[k];
}

}  // namespace tandem::mbs
