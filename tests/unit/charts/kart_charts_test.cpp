// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/kart_charts.hpp"

#include <gtest/gtest.h>

#include "refusal.hpp"
#include "scratch.hpp"

namespace tandem::charts {
namespace {

bool holds(const Picture& picture, const std::string& text) {
  return picture.script().find(text) != std::string::npos;
}

std::vector<KartLevel> traces_of(const std::string& rows) {
  const test::Scratch folder;
  const std::string header =
      "level,run,schedule,to_fast,to_slow,time,difference,throttle,gear,torque,pitch,speed,front_load,"
      "rear_load,front_slip,rear_slip\n";
  return read_kart_traces(folder.write("traces.csv", header + rows));
}

std::vector<KartWork> work_of(const std::string& rows) {
  const test::Scratch folder;
  const std::string header = "level,ratio,schedule,to_fast,to_slow,max_pitch_difference,seconds,status\n";
  return read_kart_work(folder.write("work.csv", header + rows));
}

const std::string point =
    "point,reference,fastest-first,lagrange2,mean,0,0,3,1,20,-0.5,0,,,,\n"
    "point,reference,fastest-first,lagrange2,mean,0.01,0,3,2,20,-0.6,1,,,,\n"
    "point,worst,parallel,lagrange3,lagrange3,0,0.25,3,1,20,-0.25,0,,,,\n"
    "point,best,fastest-first,lagrange1,mean,0,0.125,3,1,20,-0.375,0,,,,\n";

/// The level is part of the name of a file and of the script.
TEST(KartCharts, ALevelThatIsNoNameIsRefused) {
  for (const char* level : {"x'; system('touch x'); y='", "../x", "a b", ""})
    EXPECT_TRUE(test::refuses(ErrorCode::input_output, {"line 2", "level", "letters, digits and _"}, [&] {
      traces_of(level + point.substr(5));
    })) << level;
}

TEST(KartCharts, ShowPitchAndDifferencesOfWorstAndBestWithTheGearsMarked) {
  const auto levels = traces_of(point);
  ASSERT_EQ(levels.size(), 1U);
  const Picture picture = kart_pitch_chart(levels[0], {"c"});
  EXPECT_EQ(picture.name(), "kart_pitch_point");
  for (const char* text :
       {"<< END\n0 -0.5\n0.01 -0.6\nEND\n", "<< END\n0 0.25\nEND\n", "<< END\n0 0.125\nEND\n",
        "set arrow from 0.01,graph 0", "worst: parallel, lagrange3, lagrange3"})
    EXPECT_TRUE(holds(picture, text)) << text;
}

TEST(KartCharts, LeaveOutWhatALevelHasNot) {
  EXPECT_FALSE(holds(kart_course_chart(traces_of(point)[0], {"c"}), "load of a wheel"));
  const auto plane =
      traces_of("plane,reference,fastest-first,lagrange2,mean,0,0,3,1,20,-0.5,0,469,757,0.01,0.02\n");
  const Picture course = kart_course_chart(plane[0], {"c"});
  EXPECT_TRUE(holds(course, "load of a wheel"));
  EXPECT_TRUE(holds(course, "<< END\n0 757\nEND\n"));
}

TEST(KartCharts, ShowErrorAgainstTimeByLevelAndScheme) {
  const Picture picture = kart_work_chart(
      work_of(
          "plane,5,fastest-first,lagrange1,mean,0.001,2,ok\nplane,100,fastest-first,lagrange1,mean,0.0107,"
          "0.5,ok\nspatial,100,parallel,lagrange3,lagrange3,,,failed\n"
          "spatial,100,parallel,lagrange2,lagrange2,10.3,0.5,unstable\n"),
      {"c"});
  EXPECT_TRUE(holds(picture, "<< END\n2 0.001\n0.5 0.0107\nEND\n"));
  EXPECT_FALSE(holds(picture, "0.5 10.3"));
  EXPECT_TRUE(holds(picture, "spatial, failed or unstable: 2"));
}

TEST(KartCharts, FillTheSheetWithAsManyPanelsAsThereAreLevels) {
  std::string rows;
  const auto height_with = [&](const char* level) {
    rows += std::string(level) + ",100,fastest-first,lagrange1,mean,0.01,0.5,ok\n";
    return kart_work_chart(work_of(rows), {"c"}).height();
  };
  const double one = height_with("point"), two = height_with("plane"), three = height_with("spatial");
  EXPECT_EQ(one, two);
  EXPECT_LT(two, three);
  EXPECT_EQ(three, height_with("spatial_scalar_spin"));
}

TEST(KartCharts, RefuseTablesWithoutRowsOrRuns) {
  EXPECT_TRUE(test::refuses(ErrorCode::input_output, {"work.csv", "no rows"},
                            [] { kart_work_chart(work_of(""), {"c"}); }));
  EXPECT_TRUE(test::refuses(ErrorCode::input_output, {"no run 'worst'", "plane"}, [] {
    kart_pitch_chart(traces_of("plane,reference,a,b,c,0,0,3,1,20,-0.5,0,469,757,0,0\n")[0], {"c"});
  }));
}

}  // namespace
}  // namespace tandem::charts
