// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A diagram that jumps and one that reads it, against both as one.
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "jumping_scenes.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/subsystem.hpp"

namespace tandem::test {
namespace {

/// The mean order with steps from 40 ms on, each half of the one before.
double order_of(JumpingRun run, std::vector<double>& errors) {
  for (run.h = 0.04; errors.size() < 5; run.h /= 2.0) errors.push_back(run.error());
  return std::log2(errors.front() / errors.back()) / 4.0;
}

using Leaders = std::vector<std::string>;

/// z bends where y jumps, which leaves order 2 for who extrapolates it. Before, errors fell with the step at
/// best.
TEST(JumpingDiagrams, AreReadToOrderTwoInEverySchedule) {
  for (const JumpingScene& scene : jumping_scenes)
    for (const auto& [schedule, order] :
         {std::pair<std::string, Leaders>{"slowest-first", {"jumping", "reading"}},
          {"slowest-first", {"reading", "jumping"}},
          {"parallel", {}}}) {
      std::vector<double> errors, before;
      EXPECT_GT(order_of({scene, schedule, "lagrange1", 0.0, order}, errors), 1.6) << scene.name << schedule;
      order_of({scene, schedule, "lagrange1", 0.0, order, false}, before);
      EXPECT_LT(errors.back(), before.back() / 20.0) << scene.name << schedule;
    }
}

TEST(JumpingDiagrams, KeepMoreWhereTheOtherLeadsAndGoesBackAsItIsInterpolatedThen) {
  std::vector<double> errors;
  EXPECT_GT(order_of({jumping_scenes[0], "slowest-first", "lagrange3", 0.0, {"reading", "jumping"}}, errors),
            3.0);
}

const std::string plant =
    "a = { kind = 'sum', inputs = ['F', 'x', 'v'], gains = [1, -25, -1] }\n"
    "v = { kind = 'integrator', input = 'a' }\nx = { kind = 'integrator', input = 'v' }\n";
const std::string filter = "q = { kind = 'lag', input = 'a', time = 0.2 }\n";
const std::string held_force =
    "e = { kind = 'sum', inputs = [1, 'q', 'x'], gains = [1, -2, -3] }\n"
    "F = { kind = 'sample', input = 'e', period = 0.1, offset = 0.013 }\n";

std::unique_ptr<Subsystem> plant_mechanism(double h) {
  mbs::SubsystemSettings settings{.step = h};
  settings.stepper.index3.tolerance = 1e-12;
  return mbs::make_subsystem(
      mbs::read_mechanism("plant",
                          "dimension = 2\n[points]\nwall = { at = [-100, 0], fixed = true }\n"
                          "P = { at = [0, 0] }\n[masses]\nm = { point = 'P', mass = 1 }\n[springs]\n"
                          "k = { points = ['wall', 'P'], stiffness = 25, damping = 1, free = 100 }\n"
                          "[inputs]\nF = { unit = 'N' }\n[forces]\n"
                          "f = { point = 'P', direction = [1, 0], magnitude = 'F' }\n[outputs]\n"
                          "a = { acceleration = 'P.x' }\nx = { position = 'P.x' }\n"),
      settings);
}

/// The acceleration follows the controller's force at once, and jumps with it at its instants.
double error_of_held_force(bool mechanism, const std::string& schedule, double h) {
  const auto mass = mechanism ? plant_mechanism(h) : part_of_scene(plant, {"F"}, {"a", "x"}, h);
  const auto lag = part_of_scene(filter, {"a"}, {"q"}, 0.7 * h),
             sampled = part_of_scene(held_force, {"q", "x"}, {"F"}, 0.0);
  RunBench bench;
  bench.add("plant", *mass).add("filter", *lag).add("control", *sampled).schedule(schedule);
  bench.connect("plant.a", "filter.a", "lagrange2").connect("filter.q", "control.q", "lagrange3");
  bench.connect("plant.x", "control.x", "lagrange3").connect("control.F", "plant.F", "");
  return difference_from(plant + filter + held_force, "q", bench.run(jumping_span).all()[1]);
}

/// Who leads waits for the row with the new acceleration: without it errors are 9e-3 and 5e-3 at 2.5 ms, of
/// order 1.
TEST(JumpingDiagrams, FollowAHeldInputAtOnceInEverySchedule) {
  for (const bool mechanism : {false, true})
    for (const auto& [schedule, order] :
         {std::pair("slowest-first", 1.8), {"fastest-first", 1.5}, {"parallel", 1.3}}) {
      std::vector<double> errors;
      for (const double h : {0.04, 0.02, 0.01, 0.005, 0.0025})
        errors.push_back(error_of_held_force(mechanism, schedule, h));
      EXPECT_GT(std::log2(errors.front() / errors.back()) / 4.0, order) << mechanism << schedule;
      EXPECT_LT(errors.back(), 2e-4) << mechanism << schedule;
    }
}

/// The plant leads a relay that switches its force, and goes back to where it did.
const std::string relay = "F = { kind = 'relay', input = 'x', low = -0.02, high = 0.01, on = -1, off = 1 }\n";

double error_behind_relay(const std::string& schedule, const Leaders& order, double h) {
  const auto mass = part_of_scene(plant, {"F"}, {"a", "x"}, h),
             switching = part_of_scene(relay, {"x"}, {"F"}, 0.7 * h),
             lag = part_of_scene(filter, {"a"}, {"q"}, 0.6 * h);
  RunBench bench;
  bench.add("plant", *mass).add("relay", *switching).add("filter", *lag).schedule(schedule);
  bench.connect("plant.x", "relay.x", "lagrange3").connect("relay.F", "plant.F", "");
  bench.connect("plant.a", "filter.a", "lagrange3");
  bench.coordination.order = order;
  return difference_from(plant + filter + relay, "q", bench.run(jumping_span).all()[2]);
}

/// It would read, up to where the plant stood, what that takes back: 1.1e-1 at 10 ms, of order 1.
TEST(JumpingDiagrams, AreNotReadFurtherThanWhatStays) {
  for (const std::vector<std::string>& order : {Leaders{}, {"plant", "relay", "filter"}}) {
    std::vector<double> errors;
    for (const double h : {0.04, 0.02, 0.01, 0.005})
      errors.push_back(error_behind_relay("slowest-first", order, h));
    EXPECT_GT(std::log2(errors.front() / errors.back()) / 3.0, 2.0);
    EXPECT_LT(errors.back(), 2e-5);
  }
}

/// The mean of the logarithm of base 2 of the errors at eight steps from h down to near its half: the error
/// of an event goes with the square of the part of a step that is left after it, which is another one each
/// time.
double mean_error_behind_relay(const std::string& schedule, const Leaders& order, double h) {
  double sum = 0.0;
  for (int k = 0; k < 8; ++k) sum += std::log2(error_behind_relay(schedule, order, h * std::exp2(-k / 8.0)));
  return sum / 8.0;
}

/// The acceleration jumps with the relay's force: its reader ends a step there, or goes back, though it does
/// not read the relay. Before, errors at 5 ms were 2e-2 to 2e-1, of order 1. After a jump the first step of
/// who leads is on one sample, which is an error of y' s^2 / 2 over a part s of a step, so of order 2; who
/// follows interpolates a line, of order 3.
TEST(JumpingDiagrams, AreFollowedBehindOneThatJumpsWithThem) {
  const std::tuple<std::string, Leaders, double> runs[] = {
      {"slowest-first", {"plant", "filter", "relay"}, 3.0},
      {"slowest-first", {"filter", "plant", "relay"}, 2.0},
      {"slowest-first", {"filter", "relay", "plant"}, 2.0},
      {"slowest-first", {"relay", "filter", "plant"}, 2.0},
      {"parallel", {}, 2.0}};
  for (const auto& [schedule, leaders, order] : runs) {
    const double coarse = mean_error_behind_relay(schedule, leaders, 0.02),
                 fine = mean_error_behind_relay(schedule, leaders, 0.00125);
    EXPECT_NEAR((coarse - fine) / 4.0, order, 0.2) << schedule;
    EXPECT_LT(std::exp2(fine), 1e-4) << schedule;
  }
}

/// A controller of the speed of such a plant, on which it acts or not, may act shortly after a switching.
double error_of_samples(bool acts, double offset, double h) {
  const std::string all = std::string("a = { kind = 'sum', inputs = ['F', 'y', 'x', 'v'], gains = [1, ") +
                          (acts ? "0.5" : "0") + ", -25, -1] }\n" + plant.substr(plant.find("v =")),
                    sample = "y = { kind = 'sample', input = 'v', period = 0.2, offset = " +
                             std::to_string(offset) + " }\n";
  const auto mass = part_of_scene(all, {"F", "y"}, {"v", "x"}, h),
             switching = part_of_scene(relay, {"x"}, {"F"}, 0.7 * h),
             control = part_of_scene(sample, {"v"}, {"y"}, 0.0);
  RunBench bench;
  bench.add("plant", *mass).add("relay", *switching).add("control", *control).schedule("slowest-first");
  bench.connect("plant.x", "relay.x", "lagrange3").connect("relay.F", "plant.F", "");
  bench.connect("plant.v", "control.v", "lagrange3").connect("control.y", "plant.y", "");
  return difference_from(all + sample + relay, "y", bench.run(jumping_span).all()[2]);
}

TEST(JumpingDiagrams, AreNotSampledFurtherThanWhatStays) {
  double most = 0.0;
  for (int k = 0; k < 40; ++k) most = std::max(most, error_of_samples(true, 0.005 * k, 0.02));
  EXPECT_LT(most, 1e-3);
}

/// Nobody reads the one that leads and may go back: its rows wait for the other, ten steps behind and more.
TEST(JumpingDiagrams, ToldLateAreToldAsTheyAre) {
  const auto jumping = part_of_scene("y = { kind = 'step', time = 1.3137, after = 1 }\n", {}, {"y"}, 1.0),
             reading = part_of_scene("z = { kind = 'lag', input = 'y', time = 0.2 }\n", {"y"}, {"z"}, 0.01);
  RunBench bench;
  bench.add("jumping", *jumping).add("reading", *reading).connect("jumping.y", "reading.y", "");
  bench.schedule("slowest-first").coordination.order = {"reading", "jumping"};
  const auto rows = bench.run(8.0).all()[1];
  ASSERT_EQ(rows.size(), 802U);
  for (const auto& row : rows)
    ASSERT_NEAR(row[2], row[0] < 1.3137 ? 0.0 : 1.0 - std::exp(-(row[0] - 1.3137) / 0.2), 1e-7) << row[0];
}

/// Inputs u and y; outputs x, a and v.
std::unique_ptr<Subsystem> diagram_of(const std::string& blocks, double step) {
  return engine::make_subsystem(
      engine::read_diagram("part",
                           "[inputs]\nu = { unit = '1' }\ny = { unit = '1' }\n[blocks]\n" + blocks +
                               "[outputs]\nx = { unit = '1' }\na = { unit = '1' }\nv = { unit = '1' }\n"),
      {.step = step});
}
std::unique_ptr<Subsystem> relay_behind_lag(double low, double high, double step) {
  return diagram_of(
      "s = { kind = 'sum', inputs = ['u', 'v'], gains = [1, 0.1] }\n"
      "v = { kind = 'lag', input = 'y', time = 0.2 }\n"
      "x = { kind = 'relay', input = 's', on = -1, off = 1, low = " +
          std::to_string(low) + ", high = " + std::to_string(high) +
          " }\na = { kind = 'sum', inputs = ['x', 'v'] }\n",
      step);
}
std::unique_ptr<Subsystem> oscillating_diagram(double stiffness, double step) {
  return diagram_of("a = { kind = 'sum', inputs = ['u', 'y', 'x', 'v'], gains = [1, 0.5, -" +
                        std::to_string(stiffness) +
                        ", -0.5] }\nv = { kind = 'integrator', input = 'a', initial = 0.3 }\n"
                        "x = { kind = 'integrator', input = 'v', initial = -0.07 }\n",
                    step);
}

/// Each may go back to events of the next, which may go back to those of the one after it: no row is told
/// that another event may still take back.
TEST(JumpingDiagrams, AreToldOnceWhereSeveralGoBackOneBehindAnother) {
  const auto plant_side = oscillating_diagram(42.0, 0.0082), one = relay_behind_lag(-0.042, 0.043, 0.0076),
             two = relay_behind_lag(-0.017, 0.013, 0.028), three = relay_behind_lag(-0.039, 0.039, 0.0118);
  RunBench bench;
  bench.add("plant", *plant_side).add("one", *one).add("two", *two).add("three", *three);
  for (const auto& [from, to] : {std::pair("three.x", "two.u"),
                                 {"plant.a", "two.y"},
                                 {"two.a", "three.u"},
                                 {"one.x", "three.u"},
                                 {"one.a", "three.y"},
                                 {"two.x", "three.y"},
                                 {"plant.x", "one.u"},
                                 {"two.a", "one.u"},
                                 {"two.x", "one.y"},
                                 {"one.x", "plant.u"},
                                 {"three.v", "plant.u"},
                                 {"two.v", "plant.y"},
                                 {"one.x", "plant.y"}}) {
    const std::string output = from;
    const bool held = output.back() == 'x' && output != "plant.x", late = output.back() == 'a';
    bench.topology.connect(
        added(connection(from, to, held ? "" : "lagrange2", late ? Lag::memory : Lag::none)));
  }
  bench.schedule("slowest-first").coordination.order = {"plant", "one", "two", "three"};
  for (const auto& rows : bench.run(2.0).all()) {
    for (std::size_t k = 1; k < rows.size(); ++k) ASSERT_GE(rows[k][0], rows[k - 1][0]) << k;
    EXPECT_NEAR(rows.back()[0], 2.0, 1e-12);
  }
}

/// A controller reads the plant as it is, and as it was a period before: neither waits for the other for
/// ever.
TEST(JumpingDiagrams, OfAPlantThatIsReadNowAndLaterGoOnToTheEnd) {
  for (const char* schedule : {"slowest-first", "fastest-first", "parallel"}) {
    const auto mass = oscillating_diagram(25.0, 0.02),
               control = diagram_of(
                   "e = { kind = 'sum', inputs = ['u', 'y'], gains = [-1, 0.5] }\n"
                   "x = { kind = 'sample', input = 'e', period = 0.1, offset = 0.013 }\n"
                   "v = { kind = 'gain', input = 'x', gain = -1 }\n"
                   "a = { kind = 'gain', input = 'x', gain = 2 }\n",
                   0.0);
    RunBench bench;
    bench.add("plant", *mass).add("control", *control).schedule(schedule);
    bench.connect("plant.x", "control.u", "lagrange3");
    bench.connect("plant.v", "control.y", "lagrange3", Lag::memory);
    bench.connect("control.x", "plant.u", "").connect("control.v", "plant.y", "");
    const auto rows = bench.run(2.0).all();
    EXPECT_NEAR(rows[0].back()[0], 2.0, 1e-12) << schedule;
    EXPECT_NEAR(rows[1].back()[0], 1.913, 0.11) << schedule;
  }
}

}  // namespace
}  // namespace tandem::test
