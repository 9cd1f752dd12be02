// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/linkage_runs.hpp"

#include <gtest/gtest.h>

#include "charts/simbody_chart.hpp"
#include "refusal.hpp"
#include "scratch.hpp"

namespace tandem::charts {
namespace {

const std::string header = "code,start,loops,method,accuracy,steps,rms_error,seconds,status\n";

std::vector<LinkageRun> runs_of(const std::string& rows) {
  const test::Scratch folder;
  return read_linkage_runs(folder.write("simbody.csv", header + rows));
}

TEST(LinkageRuns, CostIsInterpolatedBetweenTheLogarithmsOfAMethodsNeighbours) {
  const auto runs = runs_of(
      "simbody,hanging,1,Rod Verlet,1e-2,9,1e-2,1e-1,ok\nsimbody,hanging,1,Rod Verlet,1e-3,9,1e-4,1e1,ok\n"
      "simbody,hanging,1,Rod CPodes,1e-3,9,1e-1,1e-2,ok\n");
  const auto cost = cost_of(runs, 1e-3);
  ASSERT_TRUE(cost.has_value());
  EXPECT_NEAR(cost->seconds, 1.0, 1e-12);
  EXPECT_FALSE(cost->bound);
  EXPECT_EQ(cost->method, "Rod Verlet");
}

TEST(LinkageRuns, CostOfACheapestRunThatIsMoreAccurateIsABound) {
  const auto cost = cost_of(runs_of("tandem,hanging,1,index3 1e-4,1e-2,9,5e-4,1e-3,ok\n"), 1e-3);
  ASSERT_TRUE(cost.has_value());
  EXPECT_EQ(cost->seconds, 1e-3);
  EXPECT_TRUE(cost->bound);
}

TEST(LinkageRuns, LostRunsHaveNoCostAndNeitherHasTooCoarseAMethod) {
  EXPECT_FALSE(cost_of(runs_of("simbody,upright,1,Rod Verlet,1e-2,9,1e-4,1e-1,lost at 2.7 s\n"
                               "simbody,upright,1,Rod CPodes,1e-2,9,1e-2,1e-1,ok\n"),
                       1e-3)
                   .has_value());
}

TEST(LinkageRuns, RatiosSayWhoTakesHowLongAndHowManyTimesAsLong) {
  const std::string text = ratios(runs_of(
      "simbody,hanging,5,Rod Verlet,1e-2,9,1e-3,1e-1,ok\ntandem,hanging,5,index3 1e-4,1e-2,9,1e-3,1e-3,ok\n"
      "tandem,hanging,5,penalty rk4,1e-2,9,5e-4,5e-4,ok\nsimbody,upright,1,Rod Verlet,1e-2,9,,1e-1,failed at "
      "1 s\n"));
  EXPECT_NE(text.find("0.1 s Rod Verlet"), std::string::npos) << text;
  EXPECT_NE(text.find("0.001 s    100  <0.0005 s   >200  penalty rk4"), std::string::npos) << text;
  EXPECT_NE(text.find("upright            1          -"), std::string::npos) << text;
}

TEST(LinkageRuns, OfOtherTablesAreRefused) {
  EXPECT_TRUE(test::refuses(ErrorCode::input_output, {"simbody.csv", "no rows"}, [] { runs_of(""); }));
  EXPECT_TRUE(test::refuses(ErrorCode::input_output, {"line 2", "seconds is something else"},
                            [] { runs_of("tandem,hanging,1,index3,1,1,1e-3,0,ok\n"); }));
}

TEST(SimbodyChart, DrawsResultsAtTheirPlaceAndWhatIsNoneInTheStrip) {
  const Picture picture = simbody_chart(runs_of("simbody,upright,1,Rod Verlet,1e-2,9,2e-2,1e-1,ok\n"
                                                "simbody,upright,1,Rod Verlet,1e-2,9,,3e-1,failed at 1 "
                                                "s\ntandem,upright,1,index3,1,9,1e-3,1e-3,ok\n"),
                                        {"conditions"});
  const std::string script = picture.script();
  for (const char* text : {"0.1 0.02\n", "0.3 4\n", "0.001 0.001\n", "'upright, L = 1'", "'conditions'"})
    EXPECT_NE(script.find(text), std::string::npos) << text;
}

}  // namespace
}  // namespace tandem::charts
