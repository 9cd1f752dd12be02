// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/mechanisms_work_chart.hpp"

#include <gtest/gtest.h>

#include "refusal.hpp"
#include "scratch.hpp"

namespace tandem::charts {
namespace {

Picture chart_of(const std::string& rows) {
  const test::Scratch folder;
  const std::string header = "mechanism,formulation,integrator,step,error,seconds,status\n";
  return mechanisms_work_chart(read_formulation_work(folder.write("work.csv", header + rows)), {"c"});
}

bool holds(const Picture& picture, const std::string& text) {
  return picture.script().find(text) != std::string::npos;
}

TEST(MechanismsWorkChart, DrawsErrorOverTimeInMilliseconds) {
  const Picture picture = chart_of(
      "pendulum,index3,newmark,0.002,1e-4,0.001,ok\npendulum,index3,newmark,0.001,2.5e-5,0.002,ok\n");
  EXPECT_TRUE(holds(picture, "<< END\n1 0.0001\n2 2.5e-05\nEND\n"));
  EXPECT_TRUE(holds(picture, "set title 'pendulum'"));
  EXPECT_FALSE(holds(picture, "failed"));
}

TEST(MechanismsWorkChart, NamesWhatFailedWithEveryStep) {
  EXPECT_TRUE(holds(chart_of("bricard,index1,rk4,0.002,,,failed\n"), "'index1 failed with 1 of 1'"));
}

TEST(MechanismsWorkChart, RefusesATableWithoutRows) {
  EXPECT_TRUE(test::refuses(ErrorCode::input_output, {"work.csv", "no rows"}, [] { chart_of(""); }));
}

}  // namespace
}  // namespace tandem::charts
