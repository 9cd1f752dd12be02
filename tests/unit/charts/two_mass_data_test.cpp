// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/two_mass_data.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "refusal.hpp"
#include "scratch.hpp"
#include "two_mass/sweep.hpp"

namespace tandem::charts {
namespace {

using test::refuses;

TEST(TwoMassData, ErrorIsTheLargerOfPositionAndAmplitudeError) {
  Result r;
  r.position_error = 0.02;
  r.amplitude_error = -0.3;
  EXPECT_EQ(r.error(), 0.3);
  r.amplitude_error = 0.01;
  EXPECT_EQ(r.error(), 0.02);
}

TEST(TwoMassData, ErrorIsInfiniteWhereARunCanNotBeJudged) {
  Result r;
  r.amplitude_error = std::nan("");
  EXPECT_TRUE(std::isinf(r.error()));
  r.amplitude_error = 0.0;
  r.failed = true;
  EXPECT_TRUE(std::isinf(r.error()));
}

TEST(TwoMassData, TheSweepIsReadAsItIsWritten) {
  const test::Scratch scratch;
  two_mass::Case c{{"slowest-first", "lagrange3", "lagrange3"}, 30.7};
  two_mass::Outcome o;
  o.figures.position_error = 0.5;
  o.figures.position_error_exact = 0.6;
  o.figures.energy_error = 0.03;
  o.figures.amplitude_error = -0.4;
  o.exchanges = 7;
  const auto file =
      scratch.write("sweep.csv", two_mass::sweep_table().header() + "\n" + two_mass::sweep_key(c) + "," +
                                     two_mass::sweep_cells(o) + "\n");
  const auto results = read_sweep(file);
  ASSERT_EQ(results.size(), 1U);
  EXPECT_EQ(results[0].scheme, c.scheme);
  EXPECT_EQ(results[0].frequency_ratio, 30.7);
  EXPECT_EQ(results[0].energy_error, 0.03);
  EXPECT_EQ(results[0].position_error, 0.6) << "by the exact x1";
  EXPECT_EQ(results[0].error(), 0.6);
  EXPECT_EQ(results[0].exchanges, 7.0);
  EXPECT_FALSE(results[0].failed);
}

TEST(TwoMassData, AFailedRunNeedsNoRunTime) {
  const test::Scratch scratch;
  const std::string row = "parallel,lagrange4,lagrange4,90,25,,,,12,30,,5,,";
  const auto results =
      read_work(scratch.write("work.csv", two_mass::work_table().header() + "\n" + row + "failed\n"));
  EXPECT_TRUE(results[0].failed);
  EXPECT_TRUE(std::isnan(results[0].seconds));
  EXPECT_EQ(results[0].steps_per_cycle, 25.0);
  const auto wrong = scratch.write("work.csv", two_mass::work_table().header() + "\n" + row + "ok\n");
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"work.csv', line 2: seconds is something else"},
                      [&] { read_work(wrong); }));
}

TEST(TwoMassData, TracesBeginAnewWithAnotherSchemeOrRatio) {
  const test::Scratch scratch;
  const auto traces =
      read_traces(scratch.write("traces.csv",
                                "frequency_ratio,schedule,to_fast,to_slow,time,x1,x1_exact,energy_error\n"
                                "90,a,b,c,0,11,11,0\n90,a,b,c,0.01,10,10.5,0.1\n"
                                "90,a,b,d,0,11,11,0\n30,a,b,d,0,11,11,0\n"));
  ASSERT_EQ(traces.size(), 3U);
  EXPECT_EQ(traces[0].time, (std::vector<double>{0.0, 0.01}));
  EXPECT_EQ(traces[0].x1_exact, (std::vector<double>{11.0, 10.5}));
  EXPECT_EQ(traces[1].scheme.to_slow, "d");
  EXPECT_EQ(traces[2].frequency_ratio, 30.0);
}

TEST(TwoMassData, BadTablesAreRefusedByLine) {
  const test::Scratch scratch;
  const std::string header = two_mass::sweep_table().header() + "\n";
  const auto refused = [&](const std::string& rows, const std::string& why) {
    const auto file = scratch.write("sweep.csv", header + rows);
    return refuses(ErrorCode::input_output, {"sweep.csv', line 2: " + why}, [&] { read_sweep(file); });
  };
  EXPECT_TRUE(refused("", "no row"));
  EXPECT_TRUE(refused("a,b,c,-3,0,0,0,0,0,0,0,0,ok,\n",
                      "frequency_ratio is something else; allowed is a number above 0"));
  EXPECT_TRUE(
      refused("a,b,c,3,0,0,0,0,0,0,0,0,good,\n", "status is something else; allowed is 'ok' or 'failed'"));
}

TEST(TwoMassData, SchemesHaveNames) {
  EXPECT_EQ(name_of({"parallel", "hermite", "hermite"}), "parallel, hermite");
  EXPECT_EQ(name_of({"fastest-first", "lagrange3", "mean"}), "fastest-first, lagrange3 / mean");
  EXPECT_EQ(name_of({"monolithic", "", ""}), "monolithic");
  EXPECT_EQ(equal_degree({"parallel", "lagrange2", "lagrange2"}), 2);
  EXPECT_EQ(equal_degree({"parallel", "lagrange2", "lagrange3"}), -1);
  EXPECT_EQ(equal_degree({"parallel", "hermite", "hermite"}), -1);
  EXPECT_FALSE(compared({"parallel", "lagrange2", "lagrange3"}));
  EXPECT_TRUE(compared({"fastest-first", "lagrange2", "mean"}));
}

}  // namespace
}  // namespace tandem::charts
