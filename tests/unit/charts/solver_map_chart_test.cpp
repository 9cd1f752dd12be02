// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/solver_map_chart.hpp"

#include <gtest/gtest.h>

#include "refusal.hpp"
#include "scratch.hpp"

namespace tandem::charts {
namespace {

const std::string header = "kind,placement,variables,filling,solver,over_best_smooth,over_best_rough\n";

Picture chart_of(const std::string& rows) {
  const test::Scratch folder;
  return solver_map_chart(read_solver_times(folder.write("solvers.csv", header + rows)), {"conditions"});
}

bool holds(const Picture& picture, const std::string& text) {
  return picture.script().find(text) != std::string::npos;
}

TEST(SolverMapChart, MarksTheBestByItsLetterSmoothAndRough) {
  const Picture picture = chart_of(
      "unsymmetric,near,100,6,klu,1.00,\nunsymmetric,near,100,6,klu_full,2.00,1.00\n"
      "unsymmetric,near,100,6,auto,1.01,\n");
  EXPECT_TRUE(holds(picture, "pt 'K'"));
  EXPECT_TRUE(holds(picture, "pt 'F'"));
  EXPECT_TRUE(holds(picture, "'conditions'"));
}

TEST(SolverMapChart, ShadesWhereAutoIsSlower) {
  const std::string best = "positive definite,near,100,6,band,1.00,1.00\n";
  EXPECT_TRUE(
      holds(chart_of(best + "positive definite,near,100,6,auto,1.10,1.10\n"), "$d1 << END\nnan nan\n"));
  EXPECT_TRUE(holds(chart_of(best + "positive definite,near,100,6,auto,1.30,1.30\n"), "$d1 << END\n100 6\n"));
}

TEST(SolverMapChart, FramesWhereTheRuleOfTheThesisIsSlower) {
  const std::string best = "positive definite,near,100,6,band,1.00,1.00\n";
  EXPECT_TRUE(
      holds(chart_of(best + "positive definite,near,100,6,thesis,1.40,2.90\n"), "$d4 << END\nnan nan\n"));
  EXPECT_TRUE(
      holds(chart_of(best + "positive definite,near,100,6,thesis,1.60,2.90\n"), "$d4 << END\n100 6\n"));
}

TEST(SolverMapChart, RefusesATableWithoutRows) {
  EXPECT_TRUE(test::refuses(ErrorCode::input_output, {"solvers.csv", "no rows"}, [] { chart_of(""); }));
}

}  // namespace
}  // namespace tandem::charts
