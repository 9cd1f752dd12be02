// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/engine_linkage_charts.hpp"

#include <gtest/gtest.h>

#include "refusal.hpp"
#include "scratch.hpp"

namespace tandem::charts {
namespace {

bool holds(const Picture& picture, const std::string& text) {
  return picture.script().find(text) != std::string::npos;
}

std::vector<EngineLinkageWork> work_of(const std::string& rows) {
  const test::Scratch folder;
  const std::string header = "loops,schedule,to_fast,to_slow,step_ratio,max_speed_error,seconds,status\n";
  return read_engine_linkage_work(folder.write("work.csv", header + rows));
}

TEST(EngineLinkageCharts, ShowErrorsByScheduleAndUnstableRunsAsCrosses) {
  const auto work = work_of(
      "1,parallel,lagrange0,lagrange0,1,0.25,2,stable\n1,parallel,lagrange0,lagrange0,10,0.5,0.4,stable\n"
      "1,parallel,lagrange0,lagrange0,50,,,unstable\n");
  const Picture errors = engine_linkage_errors_chart(work, {"c"});
  EXPECT_TRUE(holds(errors, "1 0.25\n10 0.5\n"));
  EXPECT_TRUE(holds(errors, "<< END\n41 20\nEND\n"));
  EXPECT_TRUE(holds(engine_linkage_work_chart(work, 1.5, {"c"}), "<< END\n2 0.25\n0.4 0.5\nEND\n"));
}

TEST(EngineLinkageCharts, ShowTheMotionAndTheElapsedTime) {
  const test::Scratch folder;
  const auto motion = read_engine_linkage_motion(
      folder.write("results.csv", "time,linkage.speed,engine.torque,engine.throttle\n0,30,254,9\n"));
  EXPECT_TRUE(holds(engine_linkage_motion_chart(motion, {"c"}), "<< END\n0 254\nEND\n"));
  const auto elapsed = read_engine_linkage_elapsed(folder.write(
      "elapsed.csv",
      "variables,seconds,engine_seconds,linkage_seconds,coordinator_seconds\n5,0.2,0.1,0.08,0.02\n"));
  EXPECT_TRUE(holds(engine_linkage_elapsed_chart(elapsed, {"c"}), "<< END\n5 0.02\nEND\n"));
}

TEST(EngineLinkageCharts, RefuseTablesWithoutRows) {
  EXPECT_TRUE(test::refuses(ErrorCode::input_output, {"work.csv", "no rows"},
                            [] { engine_linkage_errors_chart(work_of(""), {"c"}); }));
}

}  // namespace
}  // namespace tandem::charts
