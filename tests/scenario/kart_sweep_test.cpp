// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The kart with its engine, coupled in steps: what a sweep measures.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "kart/builtins.hpp"
#include "kart/player.hpp"
#include "kart/sweep.hpp"
#include "refusal.hpp"
#include "sources/all.hpp"

namespace tandem::kart {
namespace {

Builtins builtins() {
  return all_sources({.tell = [](const std::string&) {}});
}

/// Three runs of 1001 rows; gears 1, 2, 3, 2 in this order; the largest difference is that of the worst.
void expect_traces(const std::string& rows, double largest) {
  std::istringstream lines(rows);
  std::map<std::string, int> count;
  std::string gears;
  double most = 0.0;
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
    ASSERT_EQ(cells.size(), 16U) << line;
    ++count[cells[1]];
    most = std::max(most, std::abs(std::stod(cells[6])));
    if (cells[1] == "reference" && (gears.empty() || gears.back() != cells[8][0])) gears += cells[8];
  }
  EXPECT_EQ(count, (std::map<std::string, int>{{"best", 1001}, {"reference", 1001}, {"worst", 1001}}));
  EXPECT_EQ(gears, "1232");
  EXPECT_NEAR(most, largest, 1e-6);  // six digits are written
}

/// The printed run of level ii: its extrema to 0.01 deg. At 10 ms the trapezoidal rule alone errs by 0.010
/// deg with the torque's mean (the period's error of the pitch, (omega h)^2/12), more with the torque at its
/// nodes. What is left for the coupling is that the kart ends steps where gears change, as it does not when
/// the torque is played to it.
TEST(KartSweep, ThePlaneAtAHundredEngineStepsErrsAsItsIntegratorDoes) {
  const Builtins all = builtins();
  const Scene scene{std::string(TANDEM_SOURCE_DIR) + "/scenarios/kart", all};
  Judge judge(scene, "plane");
  const auto& pitch = judge.reference().better.pitch;
  ASSERT_EQ(pitch.size(), 100001U);
  EXPECT_NEAR(*std::min_element(pitch.begin(), pitch.end()), -2.464, 0.01);
  EXPECT_NEAR(*std::max_element(pitch.begin(), pitch.end()), 0.785, 0.01);
  EXPECT_LT(difference(judge.reference().thesis, judge.reference().better).largest, 0.002);

  const Outcome mean = judge.judge(100, {"fastest-first", "lagrange1", "mean"}, false);
  EXPECT_NEAR(mean.integrator.largest, 0.0105, 0.001);
  EXPECT_LT(mean.coupling.largest, 0.0025);
  EXPECT_LT(mean.from_better.largest, mean.integrator.largest + mean.coupling.largest + 1e-12);
  const Outcome thesis = judge.judge(100, thesis_scheme, false);
  EXPECT_GT(thesis.from_better.largest, 5.0 * mean.from_better.largest);

  const Scheme apart{"parallel", "lagrange2", "lagrange1"};
  const Outcome drifted = judge.judge(100, apart, false);
  EXPECT_TRUE(drifted.course.failure.empty());
  EXPECT_EQ(drifted.course.pitch.size(), 1001U);
  EXPECT_TRUE(scheme_row("plane", 100, apart, drifted).ends_with(",unstable"));

  Extremes extremes;
  for (const auto& [scheme, outcome] : {std::pair(Scheme{"fastest-first", "lagrange1", "mean"}, &mean),
                                        {thesis_scheme, &thesis},
                                        {apart, &drifted}})
    extremes.add(scheme, *outcome);
  EXPECT_EQ(extremes.worst()->scheme.schedule, "slowest-first");
  expect_traces(trace_rows(judge, extremes), thesis.from_better.largest);
}

TEST(KartSweep, TheWorkOfASchemeIsARowOfItsError) {
  const Builtins all = builtins();
  const Scene scene{std::string(TANDEM_SOURCE_DIR) + "/scenarios/kart", all};
  Judge judge(scene, "point");
  const std::string row = work_row(judge, 100, thesis_scheme);
  const Outcome again = judge.judge(100, thesis_scheme, false);
  EXPECT_TRUE(row.starts_with(
      fmt::format("point,100,slowest-first,lagrange0,lagrange0,{:.5g},", again.from_better.largest)))
      << row;
  EXPECT_TRUE(row.ends_with(",ok"));
}

/// What kart, engine and coordinator take is the whole, and stands in the row and in the line to read.
TEST(KartSweep, SharesOfBothSidesAndOfTheCoordinatorAreTheWhole) {
  const Builtins all = builtins();
  const Scene scene{std::string(TANDEM_SOURCE_DIR) + "/scenarios/kart", all};
  const Course c = couple(scene, {"plane", 100}, thesis_scheme, true);
  EXPECT_GT(c.kart_share, 0.0);
  EXPECT_GT(c.engine_share, 0.0);
  EXPECT_GT(c.coordinator_share, 0.0);
  EXPECT_NEAR(c.kart_share + c.engine_share + c.coordinator_share, 1.0, 1e-12);
  EXPECT_TRUE(shares_row("plane", 100, c).starts_with(fmt::format("plane,100,{:.4f},", c.kart_share)));
  Outcome o;
  o.course.seconds = 0.5, o.course.engine_share = 0.75;
  o.from_better = {0.13, 0.03125};
  EXPECT_EQ(multirate_line("plane", 5, 2.0, o),
            "| plane | 5 | 0.5 | 4 | 20 | 0 % | 75 % | 0 % | 0.13° (0.03°) |\n");
}

/// However large the pitch's difference: a run is unstable by its torque alone.
TEST(KartSweep, ARunIsUnstableIfItsTorqueLeavesTheReferencesRangeByHalfItsWidth) {
  const std::vector<double> reference{0.0, 160.0, 40.0};
  EXPECT_TRUE(stays_near({20.0, -80.0, 240.0}, reference));
  EXPECT_FALSE(stays_near({20.0, -80.1, 240.0}, reference));
  EXPECT_FALSE(stays_near({20.0, 240.1}, reference));
  EXPECT_FALSE(stays_near({20.0, std::nan("")}, reference));
  Outcome late;
  late.from_better.largest = 90.0;
  EXPECT_STREQ(late.status(), "ok");
  late.stable = false;
  EXPECT_STREQ(late.status(), "unstable");
  late.course.failure = "no convergence";
  EXPECT_STREQ(late.status(), "failed");
}

TEST(KartSweep, DifferencesAreAtTheCoarserSteps) {
  const Course coarse{{0.0, 1.0, 3.0}, {}}, fine{{0.0, 9.0, 2.0, 9.0, 3.0}, {}};
  EXPECT_EQ(difference(coarse, fine).largest, 1.0);
  EXPECT_NEAR(difference(coarse, fine).rms, std::sqrt(1.0 / 3.0), 1e-15);
}

TEST(KartSweep, ARecordOfTheTorqueIsNotPlayedBeyondItsEnd) {
  const auto player = make_player({1.0, 2.0, 3.0}, 0.5);
  double memory[16];
  Samples y(memory, 3, 4);
  player->initialize(0.0, 9.0, {}, y);
  player->advance(1.0, false, {}, y);
  ASSERT_EQ(y.size(), 3);
  EXPECT_EQ(y.values(2)[0], 3.0);
  EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument, {"ends before t = 1.5"},
                            [&] { player->advance(2.0, false, {}, y); }));
}

}  // namespace
}  // namespace tandem::kart
