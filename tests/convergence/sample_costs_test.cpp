// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What a fast controller costs those that have nothing to do with it.
#include <gtest/gtest.h>

#include "sampled_scene.hpp"

namespace tandem::test {
namespace {

/// A mechanism with steps of 2 ms that is joined to a motor with steps of 20 us, which a controller samples
/// every `period`; and a pair, of 1 and 2 ms, that nobody else is joined to.
SampledScene beside_a_motor(double period) {
  Part mechanism = oscillator(6.0, 0.05, 0.5), motor = oscillator(300.0, 0.3, 0.0);
  motor.system.b = matrix({{0.0, 0.0}, {40.0, 1.0}});  // the mechanism's position, the controller's current
  motor.system.d = MatrixXd::Zero(2, 2);
  const Part control = {
      {matrix({{1.0}}), matrix({{0.1 * period}}), matrix({{-1.0}}), matrix({{-3.0}}), VectorXd::Zero(1)},
      LinearController::Times{period}};
  return {{mechanism, motor, control, oscillator(5.0, 0.1, 1.0), oscillator(7.0, 0.1, 0.2)},
          {{0, 0, 1, 0}, {1, 0, 0, 0}, {1, 0, 2, 0}, {2, 0, 1, 1}, {3, 0, 4, 0}, {4, 0, 3, 0}},
          {{2e-3}, {2e-5}, {}, {2e-3}, {1e-3}},
          0.0,
          0.1};
}

/// By part.
std::vector<std::int64_t> exchanges(const SampledScene& scene, const std::string& schedule) {
  SampledRun run(scene, schedule);
  run.run();
  std::vector<std::int64_t> all;
  for (int i = 0; i < run.bench.topology.size(); ++i)
    all.push_back(run.bench.coordinator->effort(i).exchanges);
  return all;
}

TEST(SampleCosts, AFastControllerCostsNoExchangeToThoseWhoNeitherReadNorFeedIt) {
  for (const std::string schedule : {"slowest-first", "fastest-first", "parallel"}) {
    const auto fast = exchanges(beside_a_motor(2e-5), schedule),
               rare = exchanges(beside_a_motor(5e-3), schedule);
    EXPECT_LE(fast[0], 51) << schedule << ": the mechanism takes 50 own steps";
    EXPECT_GE(fast[1], 5000) << schedule << ": the motor stops at each sample";
    EXPECT_EQ(fast[2], 5001) << schedule;
    EXPECT_LE(rare[1], 5000 / 20) << schedule << ": the motor's steps go in calls of many";
    for (const int i : {0, 3, 4}) {
      const auto k = static_cast<std::size_t>(i);
      EXPECT_LE(fast[k], rare[k] + 1) << schedule << ", part " << i;
    }
  }
}

}  // namespace
}  // namespace tandem::test
