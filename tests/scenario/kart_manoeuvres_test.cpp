// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The kart's manoeuvres as scenarios: what they do, and what is told where their models end.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene_run.hpp"

namespace tandem {
namespace {

using test::contains;
using test::kart_folder;
using test::Said;
using test::SceneRun;
using test::Scratch;
using test::tandem;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

/// To the left: it turns to the left, leans and loads the wheels to the right; the weight stays.
TEST(KartManoeuvres, AStepOfTheSteeringWheelLeansTheKartOutwards) {
  const SceneRun run(kart_folder + "step_steer.toml");
  ASSERT_EQ(run.said().status, 0) << run.said().err;
  EXPECT_GT(run.last("kart.yaw"), 1.0);
  EXPECT_GT(run.last("kart.y"), 10.0);
  EXPECT_GT(run.last("kart.roll"), 0.03);  // left side up [rad]
  EXPECT_GT(run.last("kart.load_FR"), run.last("kart.load_FL") + 100.0);
  const double weight = run.last("kart.load_FL") + run.last("kart.load_FR") + run.last("kart.load_RL") +
                        run.last("kart.load_RR");
  EXPECT_NEAR(weight, 250.0 * 9.81, 0.5);
}

/// To and fro about its way: roll of either sign, the same to 10 %.
TEST(KartManoeuvres, ASlalomSwingsBothWays) {
  const SceneRun run(kart_folder + "slalom.toml");
  ASSERT_EQ(run.said().status, 0) << run.said().err;
  const auto& roll = run.column("kart.roll");
  const auto [least, most] = std::minmax_element(roll.begin(), roll.end());
  EXPECT_GT(*most, 0.03);
  EXPECT_NEAR(-*least / *most, 1.0, 0.1);
}

/// The throttle is an input: whoever gives it drives.
TEST(KartManoeuvres, AControllerHoldsTheSpeedByTheThrottle) {
  const SceneRun run(kart_folder + "cruise.toml");
  ASSERT_EQ(run.said().status, 0) << run.said().err;
  const auto& time = run.times();
  const auto before = std::lower_bound(time.begin(), time.end(), 8.0 - 1e-9) - time.begin();
  EXPECT_NEAR(run.column("kart.speed").at(static_cast<std::size_t>(before)), 9.0, 0.15);
  EXPECT_NEAR(run.last("kart.speed"), 12.0, 0.2);
}

/// Beside the turn's: load goes to the front, the nose dives.
TEST(KartManoeuvres, BrakingInATurnLoadsTheFront) {
  const SceneRun run(kart_folder + "braking_in_turn.toml");
  ASSERT_EQ(run.said().status, 0) << run.said().err;
  EXPECT_GT(run.last("kart.load_FL") + run.last("kart.load_FR"), 2.0 * 469.375 + 100.0);
  EXPECT_GT(run.last("kart.pitch"), 0.02);  // nose down [rad]
  EXPECT_LT(run.last("kart.speed"), 4.0);
}

/// The rung of braking_in_turn.toml: couples of two wheels of 40 and two of 20 N m over the radius, air and
/// rolling brake mass and spins. The slips, which are taken for constant, are 0.5 % of it.
TEST(KartManoeuvres, ThePlaneBrakesAsItsCouplesSay) {
  const auto brake = [](const std::string& axle) {
    return ", { from = 'driver.brake_" + axle + "', to = 'kart.brake_" + axle +
           "', reconstruction = 'lagrange1' }";
  };
  const SceneRun run(
      kart_folder + "plane_manoeuvre.toml",
      {"subsystems.driver.source=diagram:driver_braking_in_turn.toml", "span.stop=6.5",
       "connections=[{ from = 'driver.torque', to = 'kart.torque', reconstruction = 'lagrange1' }" +
           brake("front") + brake("rear") + "]"});
  ASSERT_EQ(run.said().status, 0) << run.said().err;
  const auto& speed = run.column("kart.speed");
  ASSERT_EQ(speed.size(), 6501U);
  const double from = speed[5500], to = speed[6500], radius = 0.139;
  const double air = 0.42 * (from * from + from * to + to * to) / 3.0;  // of a speed that falls linearly
  const double force = 2.0 * (40.0 + 20.0) / radius + air + 0.02 * 250.0 * 9.81;
  EXPECT_NEAR((from - to) / (force / (250.0 + 0.3 / (radius * radius))), 1.0, 0.0075);
  EXPECT_GT(run.last("kart.load_front"), run.column("kart.load_front")[4000] + 80.0);
}

TEST(KartManoeuvres, AKerbLiftsAWheelWhichIsToldOnce) {
  const SceneRun run(kart_folder + "kerb.toml");
  ASSERT_EQ(run.said().status, 0) << run.said().err;
  EXPECT_EQ(count(run.said().err, "the front left wheel is off the ground"), 1U) << run.said().err;
  const auto& load = run.column("kart.load_FL");
  EXPECT_EQ(*std::min_element(load.begin(), load.end()), 0.0);
  EXPECT_NEAR(run.last("kart.load_FL"), run.last("kart.load_FR"), 5.0);  // it has come to rest again
}

TEST(KartManoeuvres, ALoadBeyondTheTyresDataIsToldOnce) {
  const SceneRun table(kart_folder + "kerb.toml", {"subsystems.kart.parameters.tyre=tmeasy"});
  ASSERT_EQ(table.said().status, 0) << table.said().err;
  EXPECT_EQ(count(table.said().err, "the load of the rear left tyre is beyond its data"), 1U)
      << table.said().err;
  const SceneRun none(kart_folder + "kerb.toml");  // the magic formula has no table
  EXPECT_EQ(count(none.said().err, "beyond its data"), 0U) << none.said().err;
}

TEST(KartManoeuvres, ANegativeBrakeIsRefusedWithItsValue) {
  const Scratch folder;
  const Said said = tandem(folder, {"run", kart_folder + "kerb.toml", "--output", "o", "--set",
                                    "subsystems.kart.inputs.brake_front=-5"});
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said.err, "'kart'") &&
              contains(said.err, "brake of a front wheel is -5 N m; allowed is 0 or more"))
      << said.err;
}

TEST(KartManoeuvres, AnUnknownLawOrLeverOrOneOfAMechanismWithoutTyresIsRefused) {
  const Scratch folder;
  const Said law =
      tandem(folder, {"run", kart_folder + "kerb.toml", "--set", "subsystems.kart.parameters.tyre=soft"});
  EXPECT_EQ(law.status, 2);
  EXPECT_TRUE(contains(law.err, "soft") && contains(law.err, "tmeasy")) << law.err;
  const Said lever =
      tandem(folder, {"run", kart_folder + "kerb.toml", "--set", "subsystems.kart.parameters.lever=long"});
  EXPECT_EQ(lever.status, 2);
  EXPECT_TRUE(contains(lever.err, "'lever' is 'long'; allowed is radius, height")) << lever.err;
  const std::string pendulum =
      std::string(TANDEM_SOURCE_DIR) + "/scenarios/mechanisms/pendulum/pendulum.toml";
  const Said none = tandem(folder, {"run", pendulum, "--set", "run.tyre=linear"});
  EXPECT_EQ(none.status, 2);
  EXPECT_TRUE(contains(none.err, "tyre")) << none.err;
}

/// The ground rises by 0.7 m under the left wheels in 0.3 s.
TEST(KartManoeuvres, ARollOverEndsWithASentence) {
  const Scratch folder;
  folder.write("driver.toml", R"(name = "tipper"
[blocks]
ground = { kind = "piecewise_linear", times = [0.2, 0.5], values = [0, 0.7] }
[outputs]
torque = { unit = "N m", from = "zero" }
ground_FL = { unit = "m", from = "ground" }
ground_RL = { unit = "m", from = "ground" }
[blocks.zero]
kind = "constant"
value = 0
)");
  const SceneRun run(kart_folder + "kerb.toml",
                     {"subsystems.driver.source=diagram:" + (folder.path() / "driver.toml").string()});
  EXPECT_EQ(run.said().status, 1) << run.said().out;
  EXPECT_TRUE(contains(run.said().err, "limit 'rolled': signal 'roll' is ") &&
              contains(run.said().err, " rad, above 0.7, from t = 0.") &&
              contains(run.said().err, "the kart rolls over"))
      << run.said().err;
  EXPECT_GT(run.column("kart.roll").size(), 200U);  // what came before is kept
}

/// The chassis has the reaction of a torque on the shaft, by which it stands up.
TEST(KartManoeuvres, AKartInItsPlaneThatTurnsOverEndsWithASentence) {
  for (const std::string& source :
       {"mechanism:" + kart_folder + "plane.toml", std::string("builtin:kart.plane")}) {
    const Scratch folder;
    folder.write("over.toml", "[subsystems.kart]\nsource = \"" + source +
                                  "\"\nparameters = { step = 1e-3, tyre = \"tmeasy\" }\n"
                                  "inputs = { torque = 1500 }\n[span]\nstop = 5\n");
    const SceneRun run((folder.path() / "over.toml").string());
    EXPECT_EQ(run.said().status, 1) << run.said().out;
    EXPECT_TRUE(contains(run.said().err, "signal 'pitch' is -0.7") &&
                contains(run.said().err, "the kart turns over"))
        << run.said().err;
    EXPECT_EQ(count(run.said().err, "the front wheels are off the ground"), 1U) << run.said().err;
  }
}

}  // namespace
}  // namespace tandem
