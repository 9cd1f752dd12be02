// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/split_pendulum_chart.hpp"

#include <gtest/gtest.h>

#include "refusal.hpp"
#include "scratch.hpp"

namespace tandem::charts {
namespace {

constexpr const char* monolithic = "null_space,0,0.1,,1,monolithic,,,none,7.5e-5,ok\n";

Picture split_pendulum_picture(const std::string& rows) {
  const test::Scratch folder;
  const std::string header =
      "formulation,carried_mass,lower_mass,fast,ratio,schedule,to_lower,to_upper,lag,largest_error,status\n";
  return split_pendulum_chart(read_split_pendulum_schemes(folder.write("schemes.csv", header + rows)), {"c"});
}

std::size_t times(const Picture& picture, const std::string& text) {
  const std::string script = picture.script();
  std::size_t count = 0;
  for (auto at = script.find(text); at != std::string::npos; at = script.find(text, at + 1)) ++count;
  return count;
}

TEST(SplitPendulumChart, DrawsErrorsAndCrossesBesideOneMechanism) {
  const Picture picture =
      split_pendulum_picture(std::string(monolithic) +
                             "null_space,0.025,0.1,lower,10,parallel,lagrange3,lagrange0,none,3.6e-3,stable\n"
                             "null_space,0,0.1,lower,10,parallel,lagrange4,mean,none,,unstable\n");
  EXPECT_EQ(times(picture, " 0.0036\n"), 1U);
  EXPECT_EQ(times(picture, " 7.5e-05\n"), 12U);  // both ends of a line in each panel
  EXPECT_EQ(times(picture, "pt 2 ps 1 lw 2 lc rgb '#009E73'"), 1U);
}

TEST(SplitPendulumChart, LeavesOutOtherRodsRatiosAndSides) {
  const Picture picture =
      split_pendulum_picture(std::string(monolithic) +
                             "null_space,0,1,lower,10,parallel,lagrange3,lagrange0,none,3.6e-3,stable\n"
                             "null_space,0,0.1,lower,2.5,parallel,lagrange3,lagrange0,none,3.6e-3,stable\n"
                             "null_space,0,0.1,upper,10,parallel,lagrange3,lagrange0,none,3.6e-3,stable\n"
                             "index3,0,0.1,lower,10,parallel,lagrange3,lagrange0,none,3.6e-3,stable\n");
  EXPECT_EQ(times(picture, " 0.0036\n"), 0U);
}

TEST(SplitPendulumChart, RefusesATableWithoutTheOneMechanism) {
  EXPECT_TRUE(test::refuses(ErrorCode::input_output, {"schemes.csv", "one mechanism"},
                            [] { split_pendulum_picture(""); }));
}

}  // namespace
}  // namespace tandem::charts
