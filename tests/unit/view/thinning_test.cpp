// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "view/thinning.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tandem::view {
namespace {

std::vector<double> counted(std::size_t rows) {
  std::vector<double> values(rows);
  std::iota(values.begin(), values.end(), 0.0);
  return values;
}

TEST(Thinning, KeepsEveryRowThatAPageCanShow) {
  const Thinning all(200'000, 1, 0);
  EXPECT_EQ(all.most_in_band(), 1U);
  EXPECT_EQ(all.bands(counted(200'000)), counted(200'000));
  EXPECT_EQ(all.ends(counted(200'000)), counted(200'000));
}

TEST(Thinning, KeepsOneOfEachNAndTheLastWhenItIsToldSo) {
  EXPECT_EQ(Thinning(10, 1, 4).bands(counted(10)), (std::vector<double>{0, 4, 8, 9}));
  EXPECT_EQ(Thinning(9, 1, 4).ends(counted(9)), (std::vector<double>{0, 4, 8}));
  EXPECT_EQ(Thinning(10'000'000, 1, 1).rows(), 10'000'000U) << "all, as it is said";
  EXPECT_EQ(Thinning(0, 1, 3).rows(), 0U);
}

TEST(Thinning, ABandHasTheSmallestAndTheLargestOfItsRowsInTheirOrder) {
  constexpr std::size_t rows = 1'000'001;
  std::vector<double> values(rows);
  for (std::size_t k = 0; k < rows; ++k) values[k] = std::sin(0.001 * static_cast<double>(k));
  values[500'003] = 7.0, values[500'004] = -7.0;
  const Thinning thinning(rows, 1, 0);
  const auto bands = thinning.bands(values), times = thinning.ends(counted(rows));
  ASSERT_LE(thinning.rows(), 200'000U);
  ASSERT_EQ(bands.size(), thinning.rows());
  ASSERT_EQ(times.size(), thinning.rows());
  EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
  EXPECT_EQ(times.front(), 0.0);
  EXPECT_EQ(times.back(), static_cast<double>(rows - 1));
  EXPECT_EQ(bands.front(), values.front());
  EXPECT_EQ(bands.back(), values.back());
  for (std::size_t k = 1; k + 2 < bands.size(); k += 2) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(times[k]),
               end = values.begin() + static_cast<std::ptrdiff_t>(times[k + 1]) + 1;
    const auto [low, high] = std::minmax_element(begin, end);
    ASSERT_EQ(std::min(bands[k], bands[k + 1]), *low);
    ASSERT_EQ(std::max(bands[k], bands[k + 1]), *high);
    ASSERT_EQ(bands[k] < bands[k + 1], low < high);
    ASSERT_LE(end - begin, static_cast<std::ptrdiff_t>(thinning.most_in_band()));
  }
}

TEST(Thinning, EmptyCellsAreLeftOutOfABandUnlessAllAreEmpty) {
  constexpr std::size_t rows = 1'000'000;
  std::vector<double> values(rows, NAN);
  for (std::size_t k = 0; k < rows / 2; k += 3) values[k] = 1.0;
  const Thinning thinning(rows, 1, 0);
  const auto bands = thinning.bands(values);
  const auto some = static_cast<std::ptrdiff_t>(bands.size() / 2 - 2);
  EXPECT_TRUE(std::all_of(bands.begin(), bands.begin() + some, [](double v) { return v == 1.0; }));
  EXPECT_TRUE(std::all_of(bands.end() - some, bands.end(), [](double v) { return std::isnan(v); }));
}

TEST(Thinning, ThePageStaysAsLargeHoweverManyRowsAndColumnsThereAre) {
  for (const std::size_t columns : {1, 30, 1000, 50'000})
    for (const std::size_t rows : {1'000, 1'000'000, 10'000'000})
      EXPECT_LE(Thinning(rows, columns, 0).rows(), std::max<std::size_t>(4'000'000 / (columns + 1), 16))
          << rows << " rows, " << columns << " columns";
}

}  // namespace
}  // namespace tandem::view
