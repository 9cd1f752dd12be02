// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Patterns and the products prepared on them, against dense matrices.
#include "tandem/mbs/sparse/products.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <random>

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

/// Sums of at most 30 products of numbers up to 1.
constexpr double rounding = 30 * 1e-15;

TEST(Products, AreThoseOfDenseMatrices) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Matrix a = random_matrix(9, 6, 25, seed);
    const MatrixXd full = dense(a.pattern, a.values);
    const VectorXd x = VectorXd::LinSpaced(9, -1.0, 1.0), y = VectorXd::LinSpaced(6, 0.3, 1.0);
    VectorXd transposed(6), added = VectorXd::Ones(9);
    multiply_transposed(a.pattern, a.values.data(), x.data(), transposed.data());
    add_product(a.pattern, a.values.data(), y.data(), added.data());
    EXPECT_LT((transposed - full.transpose() * x).norm(), rounding);
    EXPECT_LT((added - VectorXd::Ones(9) - full * y).norm(), rounding);
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

}  // namespace
}  // namespace tandem::mbs
