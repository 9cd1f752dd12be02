// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "charts/flat_position_chart.hpp"
#include "charts/linkage_cost_chart.hpp"
#include "charts/linkage_errors_chart.hpp"
#include "refusal.hpp"
#include "scratch.hpp"

namespace tandem::charts {
namespace {

bool holds(const Picture& picture, const std::string& text) {
  return picture.script().find(text) != std::string::npos;
}

Picture cost_of(const std::string& rows) {
  const test::Scratch folder;
  const std::string header = "solver,loops,variables,step,newton_tolerance,ns_per_step_variable,status\n";
  return linkage_cost_chart(read_linkage_times(folder.write("four_bar.csv", header + rows)), {"conditions"});
}

TEST(LinkageCostChart, ShowsTheStepAndItsPartForEachVariable) {
  const Picture picture = cost_of(
      "auto,5,12,0.00125,1e-05,90,ok\nauto,500,1002,0.00125,1e-05,60,ok\nauto,5,12,0.001,1e-05,70,ok\n"
      "klu,5,12,0.00125,1e-05,,failed: why\n");
  EXPECT_TRUE(holds(picture, "<< END\n12 1.08\n1002 60.12\nEND\n"));
  EXPECT_TRUE(holds(picture, "<< END\n12 90\n1002 60\nEND\n"));
  EXPECT_FALSE(holds(picture, "title 'klu'"));
}

TEST(LinkageCostChart, RefusesATableWithoutItsStep) {
  EXPECT_TRUE(test::refuses(ErrorCode::input_output, {"no row of step 1.25e-3 s"},
                            [] { cost_of("auto,5,12,0.001,1e-05,90,ok\n"); }));
}

Picture errors_of(const std::string& rows) {
  const test::Scratch folder;
  const std::string header = "loops,formulation,settings,step,newton_tolerance,x_error,status\n";
  return linkage_errors_chart(read_linkage_errors(folder.write("four_bar.csv", header + rows)),
                              {"conditions"});
}

TEST(LinkageErrorsChart, DrawsWhatDidNotReachTheEndAsACross) {
  const Picture picture = errors_of(
      "1,index3,,0.00125,1e-10,2e-4,ok\n2,index3,,0.00125,1e-10,1.5e-3,ok\n"
      "4000,index3,,0.00125,1e-10,,lost at 16.5\n1,penalty,,0.00125,,3e-6,ok\n"
      "2,index3,projections = 3,0.00125,1e-10,9e-4,ok\n");
  EXPECT_TRUE(holds(picture, "<< END\n1 0.0002\n2 0.0015\nEND\n"));
  EXPECT_TRUE(holds(picture, "<< END\n4000 4\nEND\n"));
}

TEST(LinkageErrorsChart, RefusesATableWithoutRows) {
  EXPECT_TRUE(test::refuses(ErrorCode::input_output, {"no row of index3"}, [] { errors_of(""); }));
}

Picture passages_of(const std::string& rows) {
  const test::Scratch folder;
  const std::string header = "formulation,integrator,time,exact_angle,tilt,angle_error\n";
  return flat_position_chart(read_passages(folder.write("four_bar_traces.csv", header + rows)),
                             {"conditions"});
}

TEST(FlatPositionChart, MarksRunsThatEndEarly) {
  const std::string all = "index3,newmark,0.6,1.0,1e-9,-1e-5\nindex3,newmark,0.7,2.0,1e-9,1e-5\n";
  EXPECT_TRUE(holds(passages_of(all), "114.591559 1e-05\n"));
  const std::string part = "penalty,rk4,0.6,1.0,1e-9,1e-5\n";
  EXPECT_TRUE(holds(passages_of(all + part), "<< END\n57.2957795 1e-09\nEND\n$"));
}

TEST(FlatPositionChart, RefusesATableWithoutRows) {
  EXPECT_TRUE(test::refuses(ErrorCode::input_output, {"no rows"}, [] { passages_of(""); }));
}

}  // namespace
}  // namespace tandem::charts
