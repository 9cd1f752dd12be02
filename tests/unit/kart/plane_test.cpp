// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "kart/plane.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kart/point.hpp"
#include "kart_torque.hpp"

namespace tandem::kart {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

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

/// The largest distance in pitch [deg] from kart and power train as one diagram where a subsystem with steps
/// of `every` times 0.1 ms replays that run's torque, joined by straight lines.
double replay_error(const std::string& integrator, std::size_t every) {
  const auto& [times, torque, pitch] = test::kart_manoeuvre();
  const auto subsystem = make_subsystem(std::make_shared<Plane>(KartData{}, TyreLaw::magic_formula),
                                        {1e-4 * static_cast<double>(every), integrator, 0.25});
  const std::int64_t size = subsystem->info().row_size();
  std::vector<double> row(static_cast<std::size_t>(size));
  Samples first(row.data(), size, 1);
  subsystem->initialize(0.0, 10.0, {torque.data(), 1}, first);
  double largest = 0.0;
  for (std::size_t k = 0; k + every < times.size(); k += every) {
    Segment line{times[k + every], times[k], {torque[k]}};
    line.c[1] = (torque[k + every] - torque[k]) / (line.end - line.origin);
    const Signal signal(&line, 1, 1);
    Samples y(row.data(), size, 1);
    subsystem->advance(times[k + every], false, {&signal, 1}, y);
    if (y.size() == 1)
      largest = std::max(largest, std::abs(degrees * row[Samples::header + 1] - pitch[k + every]));
  }
  return largest;
}

/// What is left: the torque jumps where a charge is taken, the straight lines don't (0.0013 degrees in steps
/// of 0.1 ms).
TEST(KartPlane, AsSubsystemFollowsTheMonolithicRun) {
  EXPECT_LT(replay_error("rk4", 4), 6e-3);
  EXPECT_LT(replay_error("newmark", 10), 1.5e-2);
}

}  // namespace
}  // namespace tandem::kart
