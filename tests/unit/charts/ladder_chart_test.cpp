// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/ladder_chart.hpp"

#include <gtest/gtest.h>

#include "refusal.hpp"
#include "scratch.hpp"

namespace tandem::charts {
namespace {

std::vector<LadderPoint> points_of(const std::string& rows) {
  const test::Scratch folder;
  return read_ladder(
      folder.write("ladder.csv", "rung,quantity,unit,difference,to_next,tolerance,seconds,status\n" + rows));
}

bool shows(const Picture& picture, const std::string& text) {
  return picture.script().find(text) != std::string::npos;
}

/// Range: 0.001 to 50. The richest, of difference 0, stands at twice the foot, what is absent at half the
/// top.
TEST(LadderChart, ShowsEachRungWithinOrBeyondTheTolerance) {
  const Picture picture = ladder_chart(
      points_of(
          "point,a.y,deg,5,5,0.01,0.1,ok\nmass,a.y,deg,,,0.01,0.05,absent\nplane,a.y,deg,0.01,0.01,0.01,"
          "0.5,ok\nspace,a.y,deg,0,0,0.01,2,ok\n"),
      {"c"});
  EXPECT_TRUE(shows(picture, "<< END\n0.5 0.01\n2 0.002\nEND\n"));
  EXPECT_TRUE(shows(picture, "<< END\n0.1 5\n0.05 25\nEND\n"));
  EXPECT_TRUE(shows(picture, "'2: mass' at graph 0.015,0.160"));
  EXPECT_TRUE(shows(picture, "'a.y [deg]'"));
}

TEST(LadderChart, RefusesTablesWithoutRowsOrTimes) {
  EXPECT_TRUE(
      test::refuses(ErrorCode::input_output, {"no rows"}, [] { ladder_chart(points_of(""), {"c"}); }));
  EXPECT_TRUE(test::refuses(ErrorCode::input_output, {"no times"},
                            [] { ladder_chart(points_of("point,a.y,1,0,0,0.1,,ok\n"), {"c"}); }));
}

}  // namespace
}  // namespace tandem::charts
