// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A relay in one subsystem and its plant in another, against the exact solution.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "cut_run.hpp"
#include "relay_scene.hpp"
#include "tandem/check.hpp"

namespace tandem::test {
namespace {

/// order: that of the slowest-first schedule, so it is turned over for the other.
std::vector<std::string> leads(const std::string& who, const std::string& schedule) {
  std::vector<std::string> order = {"relay", "plant"};
  if ((order[0] == who) == (schedule == "fastest-first")) std::swap(order[0], order[1]);
  return schedule == "parallel" ? std::vector<std::string>{} : order;
}

RelayRun relay_run(const std::string& schedule, const std::string& leader, const std::string& how, double h) {
  RelayRun run{.schedule = schedule, .how = how, .relay_step = 0.7 * h, .plant_step = h};
  run.system.jump = 1.0, run.system.gain_y = 3.0;
  run.order = leads(leader, schedule);
  return run;
}

/// Errors of x with steps from `h` on, each half of the one before; and the mean order of these.
double observed_order(RelayRun run, int halvings, std::vector<double>* all = nullptr) {
  std::vector<double> errors;
  for (int k = 0; k <= halvings; ++k, run.relay_step /= 2.0, run.plant_step /= 2.0) {
    RelayBench bench(run);
    errors.push_back(bench.error(bench.run()));
  }
  if (all) *all = errors;
  return std::log2(errors.front() / errors.back()) / halvings;
}

/// The plant's own step is cut at each event: degree 3 gives order 3, as on the first step after a jump the
/// plant has two samples of it; degree 1 order 2.
TEST(Events, OfALeaderKeepTheOrder) {
  for (const std::string schedule : {"slowest-first", "fastest-first"}) {
    std::vector<double> cubic, linear;
    EXPECT_GT(observed_order(relay_run(schedule, "relay", "lagrange3", 0.02), 3, &cubic), 2.8) << schedule;
    EXPECT_NEAR(observed_order(relay_run(schedule, "relay", "lagrange1", 0.02), 3, &linear), 2.0, 0.4);
    EXPECT_LT(cubic.back(), 1e-6) << schedule;
  }
}

TEST(Events, OfAFollowerAreOfOrderTwoAsItsLeaderGoesBack) {
  for (const std::string schedule : {"slowest-first", "fastest-first"}) {
    RelayRun run = relay_run(schedule, "plant", "lagrange3", 0.02);
    std::vector<double> errors;
    EXPECT_NEAR(observed_order(run, 3, &errors), 2.0, 0.4) << schedule;
    EXPECT_LT(errors.back(), 2e-4) << schedule;
  }
}

/// In parallel those with events go first, and the others to the event.
TEST(Events, InParallelAreOfOrderTwo) {
  std::vector<double> errors;
  EXPECT_GT(observed_order(relay_run("parallel", "", "lagrange2", 0.02), 3, &errors), 2.0);
  EXPECT_LT(errors.back(), 1e-4);
}

/// As it was before there were events: 1e-2 for 1e-4 at steps of 5 ms.
TEST(Events, ThatTheLeaderDoesNotGoBackToAreOfOrderOneAndTold) {
  RelayRun run = relay_run("slowest-first", "plant", "lagrange3", 0.01);
  run.landing = Landing::never;
  std::vector<double> errors;
  EXPECT_NEAR(observed_order(run, 3, &errors), 1.0, 0.5);
  RelayBench bench(run);
  bench.run();
  const auto& notes = bench.bench.coordinator->notes();
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
    return note.find("'plant' had passed events of 'relay'") != std::string::npos;
  }));
}

/// A relay in a diagram, its plant in another subsystem. The diagram's own errors are of order 4, or its
/// tolerance.
TEST(Events, OfADiagramKeepTheOrder) {
  const engine::AdaptiveSettings fine{.relative_tolerance = 1e-10, .absolute_tolerance = 1e-12};
  for (const engine::IntegratorSettings& integrator :
       {engine::IntegratorSettings{}, {.name = "cvode_adams", .adaptive = fine}}) {
    RelayRun run = relay_run("slowest-first", "relay", "lagrange3", 0.02);
    run.model = RelayRun::Model::diagram;
    run.integrator = integrator;
    std::vector<double> leads, follows, parallel;
    EXPECT_GT(observed_order(run, 3, &leads), 2.8) << integrator.name;
    EXPECT_LT(leads.back(), 1e-6) << integrator.name;
    run.order = {"plant", "relay"};
    EXPECT_NEAR(observed_order(run, 3, &follows), 2.0, 0.4) << integrator.name;
    EXPECT_LT(follows.back(), 2e-4) << integrator.name;
    run.schedule = "parallel", run.order = {};
    EXPECT_GT(observed_order(run, 3, &parallel), 1.4) << integrator.name;
    EXPECT_LT(parallel.back(), 1e-4) << integrator.name;
  }
}

/// A reader that does not end a step at an event reads its jump within a step, which it splits there.
TEST(Events, OfALeaderKeepTheOrderForWhoSplitsItsStepsThere) {
  RelayRun run = relay_run("slowest-first", "relay", "lagrange3", 0.02);
  run.landing = Landing::never;
  std::vector<double> errors;
  EXPECT_GT(observed_order(run, 3, &errors), 2.5);
}

/// Any run has the same bits when it is cut and resumed, and each event stands in two rows at one time.
TEST(Events, OfRandomRunsAreCutAndResumedAnywhere) {
  std::mt19937 random(7);
  const auto uniform = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  const char* const schedules[] = {"slowest-first", "fastest-first", "parallel", "staggered"};
  const char* const hows[] = {"lagrange0", "lagrange1", "lagrange3", "least_squares2_3", "lagrange4"};
  for (int k = 0; k < 120; ++k) {
    RelayRun run{.schedule = schedules[k % 4], .how = hows[k % 5]};
    if (run.schedule == "staggered") run.how = "matched_hold";
    run.plant_step = uniform(0.002, 0.05), run.relay_step = uniform(0.002, 0.05);
    run.span = uniform(1.0, 2.0), run.t_start = k % 4 == 0 ? uniform(-3.0, 3.0) : 0.0;
    run.system.jump = uniform(0.0, 1.0), run.system.gain_y = uniform(0.0, 3.0);
    run.landing = k % 7 == 0 ? Landing::never : Landing::automatic;
    if (k % 3 == 1) run.order = leads(k % 2 ? "relay" : "plant", run.schedule);
    const auto whole = RelayBench(run).run();
    RelayBench before(run), after(run);
    const int cut = static_cast<int>(random() % 60);
    ASSERT_TRUE(
        same_bits(cut_after(cut, before.bench, after.bench, {run.t_start, run.t_start + run.span}), whole))
        << k << " " << run.schedule << " " << run.how << ", cut after round " << cut;
    for (std::size_t r = 1; r < whole[0].size(); ++r)
      if (whole[0][r][1] == 1.0) {
        EXPECT_EQ(whole[0][r][0], whole[0][r - 1][0]);
        EXPECT_EQ(whole[0][r][2], -whole[0][r - 1][2]);
      }
  }
}

/// A row of x is off by the rounding of time stamps, 1e-16 max(|t|, 1) s, times speeds of up to 2 m/s, and
/// 20 switchings make that grow a hundredfold.
/// Its input rises through the threshold.
TEST(Events, OfARelayKeepTheContract) {
  const Opener open = [] { return std::make_unique<FixedStep<Relay>>(Relay({}, 0.01)); };
  for (const Finding& f : check(open, {.inputs = {0.0}})) ADD_FAILURE() << f.check << ": " << f.sentence;
  for (const Finding& f : check(open, {.t_start = -7.3, .inputs = {0.0}}))
    ADD_FAILURE() << f.check << ": " << f.sentence;
}

TEST(Events, AreTheSameWhereverTimeStarts) {
  for (const std::string schedule : {"slowest-first", "fastest-first", "parallel"})
    for (const std::string leader : {"relay", "plant"}) {
      RelayRun run = relay_run(schedule, leader, "lagrange3", 0.01);
      const auto expected = RelayBench(run).run();
      for (const double t : {0.1, -1.3, 100.1, 1e5}) {
        run.t_start = t;
        const auto rows = RelayBench(run).run();
        ASSERT_EQ(rows[1].size(), expected[1].size()) << schedule << " " << t;
        for (std::size_t r = 0; r < rows[1].size(); ++r)
          ASSERT_NEAR(rows[1][r][2], expected[1][r][2], 1e-13 * std::max(1.0, std::abs(t)))
              << schedule << " from " << t << " s at " << rows[1][r][0];
      }
    }
}

/// A leader that is fast beside the one with events goes back over many of its own steps.
TEST(Events, AreGoneBackToOverManySteps) {
  for (const double ratio : {0.1, 0.02}) {
    RelayRun run{
        .schedule = "fastest-first", .how = "lagrange3", .relay_step = 0.02, .plant_step = 0.02 * ratio};
    RelayBench bench(run);
    EXPECT_LT(bench.error(bench.run()), 2e-9) << ratio;
    const auto& notes = bench.bench.coordinator->notes();
    EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
      return note.find("'plant' went back") != std::string::npos;
    }));
  }
}

}  // namespace
}  // namespace tandem::test
