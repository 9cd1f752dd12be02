// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/nearest.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

const std::vector<std::string> words = {"schedule", "start", "stop", "communication_step"};

TEST(Nearest, FindsAWordDespiteSlips) {
  EXPECT_EQ(nearest("schedule", words), "schedule");
  EXPECT_EQ(nearest("shcedule", words), "schedule");
  EXPECT_EQ(nearest("schedul", words), "schedule");
  EXPECT_EQ(nearest("sstart", words), "start");
  EXPECT_EQ(nearest("comunication_stp", words), "communication_step");
}

TEST(Nearest, IsEmptyIfNothingIsNear) {
  EXPECT_EQ(nearest("tolerance", words), "");
  EXPECT_EQ(nearest("", words), "");
  EXPECT_EQ(nearest("start", {}), "");
}

TEST(Nearest, TakesTheFirstOfEquallyNearOnes) { EXPECT_EQ(nearest("x1", {"x2", "x3"}), "x2"); }

}  // namespace
}  // namespace tandem
