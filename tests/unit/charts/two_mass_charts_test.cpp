// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/two_mass_charts.hpp"

#include <gtest/gtest.h>

#include "refusal.hpp"

namespace tandem::charts {
namespace {

using test::refuses;

const Caption caption = {"conditions"};

Result result(const Scheme& scheme, double ratio, double error, double amplitude_error) {
  Result r;
  r.scheme = scheme;
  r.frequency_ratio = ratio;
  r.position_error = r.energy_error = error;
  r.amplitude_error = amplitude_error;
  return r;
}

std::vector<Result> sweep(double error, double amplitude_error) {
  std::vector<Result> results;
  for (const char* schedule : {"slowest-first", "fastest-first"})
    for (int degree = 0; degree < 5; ++degree) {
      const std::string lagrange = "lagrange" + std::to_string(degree);
      results.push_back(result({schedule, lagrange, lagrange}, 10.0, 0.01, 0.0));
      results.push_back(result({schedule, lagrange, lagrange}, 20.0, error, amplitude_error));
    }
  return results;
}

bool holds(const Picture& picture, const std::string& text) {
  return picture.script().find(text) != std::string::npos;
}

Trace trace(double ratio, double energy_error) {
  return {{"slowest-first", "lagrange3", "lagrange3"},
          ratio,
          {0.0, 50.0, 100.0},
          {11, 10, 9},
          {11, 10.5, 9},
          {0.0, energy_error, 0.01}};
}

TEST(TwoMassCharts, ErrorsUpToHalfAreDrawnAsResults) {
  EXPECT_TRUE(holds(errors_chart(sweep(0.5, 0.0), caption), "\n20 50\n"));
}

TEST(TwoMassCharts, ErrorsAboveHalfInterruptTheLineAndAreNotDrawnAsResults) {
  const Picture picture = errors_chart(sweep(0.51, 0.0), caption);
  EXPECT_FALSE(holds(picture, "\n20 51\n"));
  EXPECT_TRUE(holds(picture, "\n10 1\n20 nan\nEND\n"));
}

TEST(TwoMassCharts, ConditionsStandInEachChart) {
  EXPECT_TRUE(holds(errors_chart(sweep(0.1, 0.0), caption), "'conditions'"));
  EXPECT_TRUE(holds(best_scheme_chart(sweep(0.1, 0.0), caption), "'conditions'"));
  EXPECT_TRUE(holds(motion_fr90_chart({trace(90, 0.0)}, caption), "'conditions'"));
  EXPECT_TRUE(holds(motion_fr30_chart({trace(30, 0.0)}, caption), "'conditions'"));
  EXPECT_TRUE(holds(energy_fr30_chart({trace(30, 0.0)}, caption), "'conditions'"));
}

TEST(TwoMassCharts, EnergyErrorsAboveHalfInterruptTheCurve) {
  EXPECT_TRUE(holds(energy_fr30_chart({trace(30, 0.4)}, caption), "0 0\n50 40\n100 1\n"));
  EXPECT_TRUE(holds(energy_fr30_chart({trace(30, 0.6)}, caption), "0 0\n50 nan\n100 1\n"));
}

TEST(TwoMassCharts, TheMotionOfAFailedRunEndsWithACross) {
  Trace failed = trace(30, 0.0);
  for (auto* column : {&failed.time, &failed.x1, &failed.x1_exact, &failed.energy_error}) column->pop_back();
  EXPECT_TRUE(holds(motion_fr30_chart({trace(30, 0.0), failed}, caption), "with points pt 2"));
  EXPECT_FALSE(holds(motion_fr30_chart({trace(30, 0.0)}, caption), "with points pt 2"));
}

TEST(TwoMassCharts, ARunThatFailedBeforeTheLastCyclesIsSaidTo) {
  Trace failed = trace(30, 0.0);
  for (auto* column : {&failed.time, &failed.x1, &failed.x1_exact, &failed.energy_error}) column->resize(2);
  EXPECT_TRUE(holds(motion_fr30_chart({trace(30, 0.0), failed}, caption), "the run failed before"));
}

TEST(TwoMassCharts, FailedRunsWithoutARunTimeAreCounted) {
  std::vector<Result> work;
  for (const double ratio : {10.0, 30.0, 90.0}) {
    Result r = result({"parallel", "lagrange1", "lagrange1"}, ratio, 0.1, 0.0);
    r.exchanges = 100.0;
    r.seconds = 0.01;
    work.push_back(r);
    r.failed = true;
    r.seconds = 0.0;
    if (ratio == 90.0) work.push_back(r);
  }
  EXPECT_TRUE(holds(work_precision_chart(work, caption), "above 50 %; 1 more failed (no run time)"));
}

TEST(TwoMassCharts, WhatIsNotInTheTableIsNamed) {
  EXPECT_TRUE(refuses(ErrorCode::input_output,
                      {"sweep.csv has no row with schedule slowest-first, lagrange0"},
                      [] { errors_chart({}, caption); }));
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"traces.csv has no row with frequency_ratio 90"},
                      [] { motion_fr90_chart({trace(30, 0.0)}, caption); }));
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"work.csv has no row with frequency_ratio 10"},
                      [] { work_precision_chart({}, caption); }));
}

}  // namespace
}  // namespace tandem::charts
