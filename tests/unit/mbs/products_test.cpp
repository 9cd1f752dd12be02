// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Patterns and the products prepared on them, against dense matrices.
#include "tandem/mbs/sparse/products.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <map>
#include <random>

#include "tandem/mbs/sparse/permutation.hpp"
#include "tandem/mbs/sparse/rank_update.hpp"

namespace tandem::mbs {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

Matrix random_matrix(int rows, int columns, int entries, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::pair<int, int>> list;
  for (int k = 0; k < entries; ++k)
    list.emplace_back(std::uniform_int_distribution(0, rows - 1)(random),
                      std::uniform_int_distribution(0, columns - 1)(random));
  Matrix a{Pattern(rows, columns, list), {}};
  for (int k = 0; k < a.pattern.size(); ++k)
    a.values.push_back(std::uniform_real_distribution(-1.0, 1.0)(random));
  return a;
}

MatrixXd dense(const Pattern& pattern, const std::vector<double>& values) {
  MatrixXd a = MatrixXd::Zero(pattern.rows(), pattern.columns());
  const auto entries = pattern.entries();
  for (std::size_t k = 0; k < entries.size(); ++k) a(entries[k].first, entries[k].second) = values[k];
  return a;
}

TEST(Pattern, StoresEachEntryOnceInCompressedColumns) {
  const Pattern p(4, 3, {{2, 1}, {0, 0}, {3, 1}, {2, 1}, {1, 0}});
  EXPECT_EQ(p.size(), 4);
  EXPECT_EQ(std::vector<int>(p.starts().begin(), p.starts().end()), (std::vector<int>{0, 2, 4, 4}));
  EXPECT_EQ(std::vector<int>(p.indices().begin(), p.indices().end()), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(p.find(3, 1), 3);
  EXPECT_EQ(p.find(3, 0), -1);
  EXPECT_EQ(p.find(0, 2), -1);
}

TEST(Pattern, LowerAndUnionHaveTheEntriesTheyShould) {
  const Pattern a(3, 3, {{0, 0}, {0, 2}, {2, 0}}), b(3, 3, {{1, 1}, {2, 0}});
  EXPECT_EQ(a.lower(), Pattern(3, 3, {{0, 0}, {2, 0}}));
  const Pattern both = unite(a, b);
  EXPECT_EQ(both, Pattern(3, 3, {{0, 0}, {0, 2}, {1, 1}, {2, 0}}));
  EXPECT_EQ(positions(b, both), (std::vector<int>{1, 2}));
}

TEST(Permuted, MovesRowsAndColumnsAlike) {
  const Matrix a = random_matrix(9, 9, 30, 3);
  const std::vector<int> order = {4, 0, 8, 2, 1, 7, 3, 6, 5};
  const Permuted p = permuted(a.pattern, order);
  std::vector<double> values(a.values.size()), back(a.values.size());
  gather(p.from, a.values.data(), values.data());
  scatter(p.from, values.data(), back.data());
  const MatrixXd before = dense(a.pattern, a.values), after = dense(p.pattern, values);
  for (int r = 0; r < 9; ++r)
    for (int c = 0; c < 9; ++c) EXPECT_EQ(after(r, c), before(order[r], order[c]));
  EXPECT_EQ(back, a.values);
}

/// Sums of at most 30 products of numbers up to 1.
constexpr double rounding = 30 * 1e-15;

TEST(Products, AreThoseOfDenseMatrices) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Matrix a = random_matrix(9, 6, 25, seed);
    const MatrixXd full = dense(a.pattern, a.values);
    const VectorXd x = VectorXd::LinSpaced(9, -1.0, 1.0), y = VectorXd::LinSpaced(6, 0.3, 1.0);
    VectorXd transposed(6), rows(9), sum(9);
    multiply_transposed(a.pattern, a.values.data(), x.data(), transposed.data());
    Rows(a.pattern).multiply(a.values.data(), y.data(), rows.data());
    EXPECT_LT((transposed - full.transpose() * x).norm(), rounding);
    EXPECT_LT((rows - full * y).norm(), rounding);
    add_scaled(9, x.data(), -2.0, rows.data(), sum.data());
    EXPECT_LT((sum - (x - 2.0 * rows)).norm(), rounding);
  }
}

/// Columns for points of so many coordinates each: one point alone, two that follow each other, two apart,
/// none; then one for a single coordinate behind them.
Matrix of_points(int dimension) {
  const std::vector<std::vector<int>> columns = {{0}, {0}, {0, 1}, {1, 3}, {2, 3}, {}};
  std::vector<std::pair<int, int>> entries = {{4 * dimension, 6}, {1, 6}};
  for (std::size_t c = 0; c < columns.size(); ++c)
    for (const int point : columns[c])
      for (int d = 0; d < dimension; ++d) entries.emplace_back(point * dimension + d, static_cast<int>(c));
  Matrix a{Pattern(4 * dimension + 1, 7, std::move(entries)), {}};
  for (int k = 0; k < a.pattern.size(); ++k) a.values.push_back(1.0 / (1.0 + k));
  return a;
}

TEST(Products, TakeThePairsAndTriplesOfPoints) {
  for (const int dimension : {2, 3}) {
    const Matrix a = of_points(dimension);
    EXPECT_EQ(a.pattern.runs()[0], (Pattern::Run{0, 2, 0, 1, dimension, 1}));
    const MatrixXd full = dense(a.pattern, a.values);
    const VectorXd x = VectorXd::LinSpaced(a.pattern.rows(), -1.0, 1.0), y = VectorXd::LinSpaced(7, 0.3, 1.0);
    VectorXd transposed(7), rows(a.pattern.rows());
    multiply_transposed(a.pattern, a.values.data(), x.data(), transposed.data());
    Rows(a.pattern).multiply(a.values.data(), y.data(), rows.data());
    EXPECT_LT((transposed - full.transpose() * x).norm(), rounding);
    EXPECT_LT((rows - full * y).norm(), rounding);
    const ColumnSquares squares = column_squares(a.pattern, a.values.data());
    EXPECT_EQ(squares.least, 0.0);
    EXPECT_NEAR(squares.most, full.colwise().squaredNorm().maxCoeff(), rounding);
  }
}

/// Columns beside each other whose rows are those before plus one, in pairs and in triples, and one by itself
/// with as many entries; then entries of the diagonal alone, three.
TEST(Products, TakeColumnsAbreast) {
  for (const int size : {2, 3}) {
    std::vector<std::pair<int, int>> entries = {{0, size}, {2, size}, {7, size}};
    for (int c = 0; c < size; ++c) entries.insert(entries.end(), {{c, c}, {c + 3, c}, {c + 7, c}});
    for (int c = size + 1; c < size + 4; ++c) entries.emplace_back(c, c);
    Matrix a{Pattern(10, size + 4, std::move(entries)), {}};
    for (int k = 0; k < a.pattern.size(); ++k) a.values.push_back(1.0 / (1.0 + k));
    ASSERT_EQ(a.pattern.runs().size(), 3U);
    EXPECT_EQ(a.pattern.runs()[0], (Pattern::Run{0, size, 0, 3, 1, size}));
    EXPECT_EQ(a.pattern.runs()[1], (Pattern::Run{size, 1, 3 * size, 3, 1, 1}));
    EXPECT_EQ(a.pattern.runs()[2], (Pattern::Run{size + 1, 3, 3 * size + 3, 1, 1, 3}));
    const VectorXd x = VectorXd::LinSpaced(10, -1.0, 1.0);
    VectorXd y(size + 4);
    multiply_transposed(a.pattern, a.values.data(), x.data(), y.data());
    EXPECT_LT((y - dense(a.pattern, a.values).transpose() * x).norm(), rounding);
  }
}

TEST(RankUpdate, IsThatOfDenseMatricesOnEitherTriangleOrBoth) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Matrix a = random_matrix(8, 7, 20, seed);
    const MatrixXd expected = 0.7 * dense(a.pattern, a.values) * dense(a.pattern, a.values).transpose();
    std::vector<std::pair<int, int>> all;
    for (int r = 0; r < 8; ++r)
      for (int c = 0; c < 8; ++c) all.emplace_back(r, c);
    const Pattern whole(8, 8, all);
    for (const Pattern& target : {whole, whole.lower()}) {
      std::vector<double> base(target.size(), 0.25), result(target.size());
      const auto entries = target.entries();
      RankUpdate(a.pattern, entries).run(a.values.data(), 0.7, base.data(), result.data());
      for (std::size_t k = 0; k < entries.size(); ++k)
        EXPECT_NEAR(result[k], 0.25 + expected(entries[k].first, entries[k].second), rounding);
    }
  }
}

/// Layouts of all entries in an order of their own: column by column, so that the coordinates of a point
/// stand together; row by row, so that they don't; of the lower triangle either way, with room for none
/// between and the diagonal named twice.
std::vector<std::vector<std::pair<int, int>>> layouts(int n) {
  std::vector<std::vector<std::pair<int, int>>> all(4);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      all[0].emplace_back(j, i);
      all[1].emplace_back(i, j);
      if (j >= i) all[2].emplace_back(j, i);
      all[3].emplace_back(j <= i ? std::pair(i, j) : std::pair(-1, -1));
    }
  for (int i = 0; i < n; ++i) all[2].emplace_back(i, i);
  return all;
}

TEST(RankUpdate, TakesTheCoordinatesOfPointsTogetherWhereTheyStandTogether) {
  for (const int dimension : {2, 3}) {
    const Matrix a = of_points(dimension);
    const int n = a.pattern.rows();
    const MatrixXd full = dense(a.pattern, a.values), expected = 0.7 * full * full.transpose();
    for (const auto& layout : layouts(n)) {
      const std::vector<double> base(layout.size(), 0.25);
      std::vector<double> result(layout.size());
      RankUpdate(a.pattern, layout).run(a.values.data(), 0.7, base.data(), result.data());
      std::map<std::pair<int, int>, double>
          found;  // both triangles and entries named twice have the same bits
      for (std::size_t k = 0; k < layout.size(); ++k) {
        const auto [row, column] = layout[k];
        ASSERT_NEAR(result[k], 0.25 + (row < 0 ? 0.0 : expected(row, column)), rounding)
            << row << " " << column;
        EXPECT_EQ(result[k], found.try_emplace(std::minmax(row, column), result[k]).first->second);
      }
    }
  }
}

/// So many columns that they are coloured.
TEST(RankUpdate, OfALargeMatrixIsThatOfItsProduct) {
  const Matrix a = random_matrix(300, 5000, 12000, 1);
  const MatrixXd full = dense(a.pattern, a.values), expected = full * full.transpose();
  std::vector<std::pair<int, int>> lower;
  for (int c = 0; c < 300; ++c)
    for (int r = c; r < 300; ++r) lower.emplace_back(r, c);
  const std::vector<double> base(lower.size(), 0.25);
  std::vector<double> result(lower.size());
  RankUpdate(a.pattern, lower).run(a.values.data(), 1.0, base.data(), result.data());
  for (std::size_t k = 0; k < lower.size(); ++k)
    EXPECT_NEAR(result[k], 0.25 + expected(lower[k].first, lower[k].second),
                40 * 1e-15);  // 40 products a row
}

}  // namespace
}  // namespace tandem::mbs
