// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "four_bar/study.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/linkage_errors.hpp"
#include "four_bar/linkage.hpp"

namespace tandem::four_bar {
namespace {

Case with(const char* formulation, const char* integrator, int loops) {
  Case c{loops, {}, 1.25e-3, ""};
  c.stepper.formulation = formulation;
  c.stepper.integrator = integrator;
  if (c.stepper.formulation == "penalty") c.stepper.penalty.penalty = 1e8;
  return c;
}

/// The flat position is passed after 0.71 and 1.23 s. The error of the trapezoidal rule in 2 s is below 1e-3
/// m.
TEST(FourBarStudy, TheDefaultKeepsTheParallelogramThroughTheFlatPosition) {
  std::vector<Place> places;
  const Result r = run(with("index3", "newmark", 2), 2.0, [&](const Place& p) { places.push_back(p); });
  EXPECT_EQ(r.status, "ok");
  EXPECT_DOUBLE_EQ(r.time, 2.0);
  EXPECT_LT(r.x_error, 1e-3);
  EXPECT_LT(r.largest_tilt, 1e-3);
  ASSERT_EQ(places.size(), 1600u);
  EXPECT_DOUBLE_EQ(places.back().time, 2.0);
  const double turn = 2.0 * std::numbers::pi;
  EXPECT_NEAR(std::remainder(places.back().angle - exact(2, 2.0).angle, turn), 0.0, 1e-3);
  EXPECT_DOUBLE_EQ(r.largest_tilt,
                   std::max_element(places.begin(), places.end(), [](const Place& a, const Place& b) {
                     return a.tilt < b.tilt;
                   })->tilt);
}

/// Before the first flat position, of order 2 within 0.2.
TEST(FourBarStudy, ErrorsFallWithTheSquareOfTheStep) {
  Case c = with("index3", "newmark", 5);
  const double coarse = run(c, 0.5).x_error;
  c.step /= 2;
  EXPECT_NEAR(std::log2(coarse / run(c, 0.5).x_error), 2.0, 0.2);
}

TEST(FourBarStudy, SaysThatTheParallelogramIsLost) {
  const Result r = run(with("penalty", "rk2", 5), 20.0);
  EXPECT_TRUE(r.status.starts_with("lost at 1.2")) << r.status;
  EXPECT_GT(r.largest_tilt, lost_tilt);
  EXPECT_LT(r.time, 1.3);
}

TEST(FourBarStudy, SaysWhatTheStepperCanNotDoAndWhere) {
  const Result r = run(with("null_space", "rk4", 2), 20.0);
  EXPECT_EQ(r.status.substr(0, 14), "failed at 0.71");
  EXPECT_TRUE(r.note.starts_with("no convergence of the dependent variables at t = 0.71")) << r.note;
  EXPECT_EQ(r.note.find(','), std::string::npos);
  EXPECT_NEAR(r.time, 0.713, 3e-3);
  EXPECT_LT(r.largest_tilt, 1e-10);  // of the last state that it reached
}

TEST(LinkageErrors, OrderIsThatOfTwiceTheStep) {
  std::vector<Case> cases = {with("index3", "newmark", 1), with("index3", "newmark", 1),
                             with("index3", "newmark", 1)};
  cases[0].step = 2.5e-3;
  cases[2].step = 1e-3;
  for (Case& c : cases) c.stepper.index3.tolerance = 1e-10;
  std::vector<Result> results(3);
  results[0].x_error = 4e-3, results[1].x_error = 1e-3;
  for (Result& r : results) r.status = "ok";
  const auto orders = [&] {
    std::vector<std::string> all;
    const bench::Table table = bench::error_table(cases, results);
    for (const auto& row : table.rows()) all.push_back(row[8]);
    return all;
  };
  EXPECT_EQ(orders(), (std::vector<std::string>{"", "2.00", ""}));
  results[0].status = "lost at 1";
  EXPECT_EQ(orders(), (std::vector<std::string>{"", "", ""}));
}

}  // namespace
}  // namespace tandem::four_bar
