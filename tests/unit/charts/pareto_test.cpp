// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/charts/pareto.hpp"

#include <gtest/gtest.h>

namespace tandem::charts {
namespace {

TEST(Pareto, KeepsWhatNothingCheaperBeats) {
  const auto front = pareto_front({{3.0, 0.2}, {1.0, 0.9}, {2.0, 0.5}, {2.0, 0.4}, {4.0, 0.2}, {5.0, 0.1}});
  ASSERT_EQ(front.size(), 4U);
  const double costs[] = {1.0, 2.0, 3.0, 5.0}, errors[] = {0.9, 0.4, 0.2, 0.1};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(front[k].x, costs[k]);
    EXPECT_EQ(front[k].y, errors[k]);
  }
}

TEST(Pareto, OfNothingIsNothing) { EXPECT_TRUE(pareto_front({}).empty()); }

}  // namespace
}  // namespace tandem::charts
