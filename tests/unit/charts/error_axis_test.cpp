// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/error_axis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tandem::charts {
namespace {

TEST(ErrorAxis, ShowsErrorsUpToHalf) {
  const ErrorAxis axis(1e-4, 3);
  EXPECT_TRUE(axis.shows(0.5));
  EXPECT_FALSE(axis.shows(0.501));
  EXPECT_FALSE(axis.shows(std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(axis.shows(std::nan("")));
}

TEST(ErrorAxis, PlacesErrorsInPercent) {
  const ErrorAxis axis(3e-4, 3);
  EXPECT_DOUBLE_EQ(axis.place(0.02), 2.0);
  EXPECT_DOUBLE_EQ(axis.place(0.0), 0.02);  // the foot: 3e-4 is 0.03 %, and the next of 1, 2, 5 below is 0.02
}

TEST(ErrorAxis, FailuresLieAboveAllResultsEachRowOnALineOfItsOwn) {
  const ErrorAxis axis(1e-4, 3);
  double below = axis.place(0.5);
  for (int row = 0; row < 3; ++row) {
    EXPECT_GT(axis.strip(row), 1.1 * below);
    below = axis.strip(row);
  }
}

}  // namespace
}  // namespace tandem::charts
