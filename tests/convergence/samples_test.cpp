// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Sampled subsystems beside continuous ones, against the exact solution.
#include <gtest/gtest.h>

#include "same_bits.hpp"
#include "sampled_scene.hpp"

namespace tandem::test {
namespace {

/// A controller with an integral and a proportional part.
Part controller(double gain, double integral, LinearController::Times times) {
  return {{matrix({{1.0}}), matrix({{integral * times.period}}), matrix({{-1.0}}), matrix({{-gain}}),
           VectorXd::Zero(1)},
          times};
}

/// One plant and one controller that reads its position.
SampledScene one_loop(double step, Method method, LinearController::Times times) {
  return {{oscillator(5.0, 0.05, 1.0), controller(4.0, 6.0, times)},
          {{0, 0, 1, 0}, {1, 0, 0, 0}},
          {{step, method}, {}}};
}

TEST(Samples, OneExactPlantThatLandsIsRightToRounding) {
  for (const auto& times :
       std::vector<LinearController::Times>{{0.1}, {0.1, 0.03}, {0.07, 0.011, 0.02}, {0.05, 0.0, 0.13}})
    for (const double step : {0.01, 0.013, 0.05}) {
      const SampledScene scene = one_loop(step, Method::exact, times);
      const auto first = run(scene, "slowest-first");
      for (const std::string& schedule : schedules) {
        const auto rows = run(scene, schedule);
        const Errors e = errors(scene, rows);
        EXPECT_LT(e.sampled, 1e-12) << schedule << " " << step << " " << times.period << " " << times.latency;
        EXPECT_LT(e.continuous, 1e-12)
            << schedule << " " << step << " " << times.period << " " << times.latency;
        EXPECT_TRUE(same_bits(rows, first)) << schedule;
        EXPECT_TRUE(same_bits(run(scene, schedule, {1, 0}), first)) << schedule;
      }
    }
}

double order_of(const std::vector<double>& errors) {
  return std::log2(errors[errors.size() - 2] / errors.back());
}

TEST(Samples, OneRungeKuttaPlantThatLandsIsOfOrderFour) {
  for (const Method method : {Method::rk4, Method::rk4_split})
    for (const LinearController::Times times : {LinearController::Times{0.1, 0.037}, {0.11, 0.0, 0.029}}) {
      std::vector<double> all;
      for (const double step : {0.04, 0.02, 0.01}) {
        const SampledScene scene = one_loop(step, method, times);
        const auto rows = run(scene, "slowest-first");
        for (const std::string& schedule : schedules)
          EXPECT_TRUE(same_bits(run(scene, schedule), rows)) << schedule;
        const Errors e = errors(scene, rows);
        all.push_back(std::max(e.sampled, e.continuous));
      }
      EXPECT_NEAR(order_of(all), 4.0, 0.25) << all[0] << " " << all[1] << " " << all[2];
    }
}

/// A plant of two masses in two continuous parts, joined by a spring, and a controller of the second that
/// moves the first.
SampledScene two_plants(double step, LinearController::Times times, const std::string& how,
                        Landing landing = Landing::automatic, Method method = Method::exact) {
  Part first = oscillator(6.0, 0.05, 0.5), second = oscillator(4.0, 0.03, 1.0);
  first.system.b = matrix({{0.0, 0.0}, {3.0, 1.0}});  // the other's position, and the controller's force
  second.system.b = matrix({{0.0}, {2.0}});
  for (Part* part : {&first, &second}) part->system.d = MatrixXd::Zero(2, part->system.b.cols());
  const Side a{step, method, how, landing}, b{0.7 * step, method, how, landing};
  return {{first, second, controller(1.5, 2.0, times)},
          {{1, 0, 0, 0}, {0, 0, 1, 0}, {1, 0, 2, 0}, {2, 0, 0, 1}},
          {a, b, {}},
          0.0,
          2.0};
}

TEST(Samples, StaggeredTakesSampledOnesBesideItsTwo) {
  for (const Landing landing : {Landing::automatic, Landing::never})
    for (const double step : {0.01, 0.005}) {
      const SampledScene scene = two_plants(step, {0.1, 0.013}, "matched_hold", landing);
      const Errors e = errors(scene, run(scene, "staggered"));
      EXPECT_LT(std::max(e.sampled, e.continuous), 5.0 * step) << step;
      EXPECT_TRUE(same_bits(run(scene, "staggered", {2, 0, 1}), run(scene, "staggered"))) << step;
    }
}

double last_order(const std::string& schedule, const std::string& how, Landing landing, Method method) {
  std::vector<double> all;
  for (const double step : {0.02, 0.01, 0.005, 0.0025}) {
    const SampledScene scene = two_plants(step, {0.1, 0.013}, how, landing, method);
    const Errors e = errors(scene, run(scene, schedule));
    all.push_back(std::max(e.sampled, e.continuous));
  }
  return order_of(all);
}

/// Velocities kink at each instant: order 3 at most.
TEST(Samples, TwoPlantsThatLandKeepTheOrderOfTheirReconstructionUpToThree) {
  for (const std::string& schedule : schedules) {
    EXPECT_NEAR(last_order(schedule, "lagrange1", Landing::automatic, Method::exact), 2.0, 0.2) << schedule;
    EXPECT_NEAR(last_order(schedule, "lagrange3", Landing::automatic, Method::exact), 3.0, 0.2) << schedule;
  }
}

TEST(Samples, InstantsBesideOwnNodesDoNoHarm) {
  for (const std::string& schedule : schedules)
    for (const double beside :
         {0.0, 1e-15, 1e-14, 1e-12, 1e-10, 1e-8, 1e-6, 1e-4, -1e-14, -1e-10, -1e-6, -1e-4})
      for (const char* how : {"lagrange1", "lagrange3", "lagrange4", "least_squares2_3"}) {
        const SampledScene scene = two_plants(0.01, {0.1, 0.1 + beside}, how);
        const Errors e = errors(scene, run(scene, schedule));
        EXPECT_LT(std::max(e.sampled, e.continuous), 2e-3) << schedule << " " << beside << " " << how;
      }
}

TEST(Samples, WithoutLandingTheOrderIsKeptByWhoSplitsAndNotByWhoGoesOverBreaks) {
  const auto worst = [](const SampledScene& scene, const std::string& schedule) {
    const Errors e = errors(scene, run(scene, schedule));
    return std::max(e.sampled, e.continuous);
  };
  for (const std::string& schedule : schedules) {
    EXPECT_NEAR(last_order(schedule, "lagrange3", Landing::never, Method::exact), 3.0, 0.2) << schedule;
    const auto over = two_plants(0.005, {0.1, 0.013}, "lagrange3", Landing::never, Method::rk4),
               split = two_plants(0.005, {0.1, 0.013}, "lagrange3", Landing::never, Method::rk4_split);
    EXPECT_GT(worst(over, schedule), 100.0 * worst(split, schedule)) << schedule;
  }
}

}  // namespace
}  // namespace tandem::test
