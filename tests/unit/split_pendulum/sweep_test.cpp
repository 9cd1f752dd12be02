// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "split_pendulum/sweep.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace tandem::split_pendulum {
namespace {

auto commas(const std::string& text) { return std::count(text.begin(), text.end(), ','); }

TEST(SplitPendulumSweep, HasNoSchemeTwice) {
  std::set<std::string> seen;
  for (const Case& c : sweep_cases()) {
    const Scheme& s = c.scheme;
    const std::string key =
        fmt::format("{} {} {} {} {} {} {} {} {}", s.formulation, s.fast, s.ratio, s.schedule, s.to_lower,
                    s.to_upper, static_cast<int>(s.lag), c.rods.lower_mass, c.rods.carried_mass);
    EXPECT_TRUE(seen.insert(key).second) << key;
  }
}

TEST(SplitPendulumSweep, LimitsAreOfDisplacementsThatHaveAnAcceleration) {
  for (const Scheme& s : limit_schemes()) {
    EXPECT_NE(s.to_lower, "matched_hold");
    EXPECT_FALSE(s.to_lower.starts_with("least_squares1")) << s.to_lower;
  }
}

TEST(SplitPendulumSweep, RowsHaveTheCellsOfTheirHeaders) {
  const std::string whole = scheme_row({{.schedule = "monolithic", .ratio = 1.0}}),
                    unstable = scheme_row({{"staggered", "matched_hold", "matched_hold"}});
  EXPECT_EQ(commas(whole), commas(schemes_header)) << whole;
  EXPECT_NE(whole.find(",stable,"), std::string::npos) << whole;
  EXPECT_EQ(commas(unstable), commas(schemes_header)) << unstable;
  EXPECT_NE(unstable.find(",unstable,lost at "), std::string::npos) << unstable;
  const std::string late = scheme_row(
      {{.schedule = "fastest-first", .to_lower = "lagrange3", .to_upper = "lagrange1", .lag = Lag::memory}});
  EXPECT_EQ(commas(late), commas(schemes_header)) << late;
  EXPECT_NE(late.find(",lagrange1,memory,"), std::string::npos) << late;
  const std::string limit = limit_row({"parallel", "lagrange4", "lagrange3", "lower"});
  EXPECT_EQ(commas(limit), commas(limits_header)) << limit;
}

}  // namespace
}  // namespace tandem::split_pendulum
