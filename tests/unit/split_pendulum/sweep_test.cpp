// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "split_pendulum/sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tandem::split_pendulum {
namespace {

auto commas(const std::string& text) { return std::count(text.begin(), text.end(), ','); }

TEST(SplitPendulumSweep, RowsHaveTheCellsOfTheirHeaders) {
  const std::string whole = scheme_row({{.schedule = "monolithic", .ratio = 1.0}}),
                    unstable = scheme_row({{"staggered", "matched_hold", "matched_hold"}});
  EXPECT_EQ(commas(whole), commas(schemes_header)) << whole;
  EXPECT_NE(whole.find(",stable,"), std::string::npos) << whole;
  EXPECT_EQ(commas(unstable), commas(schemes_header)) << unstable;
  EXPECT_NE(unstable.find(",unstable,lost at "), std::string::npos) << unstable;
  const std::string limit = limit_row({"parallel", "lagrange4", "lagrange3", "lower"});
  EXPECT_EQ(commas(limit), commas(limits_header)) << limit;
}

}  // namespace
}  // namespace tandem::split_pendulum
