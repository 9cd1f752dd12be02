// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "kart/plane.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kart/monolithic.hpp"
#include "kart/point.hpp"

namespace tandem::kart {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

const Monolithic& plane_run() {
  static const Monolithic run = [] {
    Plane kart(KartData{}, TyreLaw::magic_formula);
    return run_monolithic(kart, 1e-4);
  }();
  return run;
}

double pitch(const Monolithic& run, double t) {
  return degrees * run.rows[static_cast<std::size_t>(std::lround(t / 1e-4))].pitch;
}

/// The printed run of the specification, to its last digit.
TEST(KartPlane, MonolithicRunHasThePrintedPitch) {
  const auto& run = plane_run();
  const std::pair<double, double> printed[] = {{1, -0.778},  {2, -2.420}, {3, -1.440}, {4, -0.979},
                                               {4.5, 0.226}, {5, -1.033}, {6, -0.110}, {8, -0.134},
                                               {9, -1.712},  {10, -1.542}};
  for (const auto& [t, value] : printed) EXPECT_NEAR(pitch(run, t), value, 1e-3) << t;
  const auto [least, most] = std::minmax_element(
      run.rows.begin(), run.rows.end(), [](const auto& a, const auto& b) { return a.pitch < b.pitch; });
  EXPECT_NEAR(degrees * least->pitch, -2.464, 1e-3);
  EXPECT_NEAR(least->time, 1.86, 5e-3);
  EXPECT_NEAR(degrees * most->pitch, 0.785, 1e-3);
  EXPECT_NEAR(most->time, 4.85, 5e-3);
  EXPECT_NEAR(run.rows.back().speed, 13.79, 5e-3);
}

TEST(KartPlane, MonolithicRunHasThePrintedShifts) {
  const auto& shifts = plane_run().shifts;
  ASSERT_EQ(shifts.size(), 3U);
  const PowerTrain::Shift printed[] = {{4.33, 1, 2, 9.52}, {4.71, 2, 3, 9.85}, {7.97, 3, 2, 9.81}};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(shifts[k].time, printed[k].time, 6e-3);
    EXPECT_EQ(shifts[k].to, printed[k].to);
    EXPECT_NEAR(shifts[k].speed, printed[k].speed, 6e-3);
  }
  EXPECT_NEAR(plane_run().rows[0].engine_speed * 30.0 / std::numbers::pi, 1015.0, 0.5);
}

/// Steps of twice the length: the printed agreement is 0.001 degrees.
TEST(KartPlane, MonolithicRunIsThatOfALongerStep) {
  Plane kart(KartData{}, TyreLaw::magic_formula);
  const Monolithic coarse = run_monolithic(kart, 2e-4);
  double largest = 0.0;
  for (std::size_t k = 0; k < coarse.rows.size(); ++k)
    largest = std::max(largest, std::abs(coarse.rows[k].pitch - plane_run().rows[2 * k].pitch));
  EXPECT_LT(degrees * largest, 2e-3);
}

TEST(KartPoint, ReachesTheSpeedAtWhichTorqueAndLossesBalance) {
  const KartData d;
  Point kart(d);
  mbs::State s = kart.standing(0.0);
  kart.torque = 20.0;
  s.v[0] = std::sqrt((20.0 / d.radius - d.rolling * d.mass * d.gravity) / d.drag);
  double force = 1.0;
  kart.forces(s.q.data(), s.v.data(), &force);
  EXPECT_NEAR(force, 0.0, 1e-9);
}

/// The largest distance in pitch from the monolithic run where a subsystem with steps of `every` times 0.1 ms
/// replays that run's torque, joined by straight lines.
double replay_error(const std::string& integrator, std::size_t every) {
  const auto& rows = plane_run().rows;
  const auto subsystem = make_subsystem(std::make_shared<Plane>(KartData{}, TyreLaw::magic_formula),
                                        {1e-4 * static_cast<double>(every), integrator, 0.25});
  const std::int64_t size = subsystem->info().row_size();
  std::vector<double> row(static_cast<std::size_t>(size));
  Samples first(row.data(), size, 1);
  subsystem->initialize(0.0, 10.0, {&rows[0].torque, 1}, first);
  double largest = 0.0;
  for (std::size_t k = 0; k + every < rows.size(); k += every) {
    Segment line{rows[k + every].time, rows[k].time, {rows[k].torque}};
    line.c[1] = (rows[k + every].torque - rows[k].torque) / (line.end - line.origin);
    const Signal signal(&line, 1, 1);
    Samples y(row.data(), size, 1);
    subsystem->advance(rows[k + every].time, false, {&signal, 1}, y);
    if (y.size() == 1)
      largest = std::max(largest, std::abs(row[Samples::header + 1] - rows[k + every].pitch));
  }
  return degrees * largest;
}

/// What is left: the torque jumps where a charge is taken, the straight lines don't (0.0013 degrees in steps
/// of 0.1 ms).
TEST(KartPlane, AsSubsystemFollowsTheMonolithicRun) {
  EXPECT_LT(replay_error("rk4", 4), 6e-3);
  EXPECT_LT(replay_error("newmark", 10), 1.5e-2);
}

}  // namespace
}  // namespace tandem::kart
