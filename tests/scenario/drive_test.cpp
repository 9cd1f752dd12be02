// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// scenarios/drive: a motor in C, a load that twists, and a speed controller that samples, against the exact
// motion.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "command.hpp"
#include "drive_scene.hpp"
#include "tandem/text/time_table.hpp"

namespace tandem::test::drive {
namespace {

using Words = std::vector<std::string>;
using text::TimeTable;

const std::string drive_folder = TANDEM_SOURCE_DIR "/scenarios/drive/";

Words operator+(Words a, const Words& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::string library(const std::string& name) {
  return "subsystems." + name + ".source=lib:" TANDEM_FILE_LIBRARIES "/drive_" + name + ".so";
}

/// Those of this build.
Words libraries_of(const std::string& file) {
  if (file == "drive.toml") return {library("motor")};
  if (file == "drive_mechanism.toml") return {library("motor"), library("controller"), library("weight")};
  return {library("motor"), library("controller")};
}

Words run_of(const std::string& file, const Words& settings) {
  Words words{"run", drive_folder + file, "--output", "o"};
  for (const std::string& s : libraries_of(file) + settings) words.insert(words.end(), {"--set", s});
  return words;
}

/// What it gives at all steps of the load.
TimeTable rows_of(const std::string& file, const Words& settings) {
  const Scratch folder;
  const Said said = tandem(folder, run_of(file, settings) + Words{"--no-reference"});
  EXPECT_EQ(said.status, 0) << said.err;
  return TimeTable::read(folder.path() / "o");
}

const std::vector<double>& column(const TimeTable& table, const std::string& name) {
  const auto at = std::find(table.names.begin(), table.names.end(), name) - table.names.begin();
  return table.columns.at(static_cast<std::size_t>(at));
}

/// The largest of all rows.
struct DriveErrors {
  double drum_speed = 0.0, twist = 0.0;  ///< [rad/s, rad]
};

DriveErrors errors_of(const TimeTable& table) {
  DriveErrors worst;
  ExactSamples exact = exact_drive();
  const auto &speed = column(table, "load.drum_speed"), &twist = column(table, "load.twist");
  for (std::size_t r = 0; r < table.times.size(); ++r) {
    const VectorXd y = exact.before(drive_load, table.times[r]);
    worst.drum_speed = std::max(worst.drum_speed, std::abs(speed[r] - y[1]));
    worst.twist = std::max(worst.twist, std::abs(twist[r] - y[2]));
  }
  return worst;
}

Words scheme(const std::string& schedule, const std::string& how) {
  return {"coordination.schedule=" + schedule, "connections[load.torque].reconstruction=" + how,
          "connections[motor.w].reconstruction=" + how};
}

class DriveScenario : public testing::TestWithParam<const char*> {};

TEST_P(DriveScenario, RunsWithinItsReference) {
  const Scratch folder;
  const Said said = tandem(folder, run_of(GetParam(), {}));
  EXPECT_EQ(said.status, 0) << said.err;
}

INSTANTIATE_TEST_SUITE_P(All, DriveScenario,
                         testing::Values("drive.toml", "drive_libraries.toml", "drive_mechanism.toml"),
                         [](const auto& test) { return std::filesystem::path(test.param).stem().string(); });

/// The file has 12 digits.
TEST(Drive, ItsReferenceIsTheExactMotion) {
  const TimeTable table = TimeTable::read(drive_folder + "exact.csv");
  ASSERT_EQ(table.names, (Words{"load.speed", "load.drum_speed", "load.twist"}));
  ASSERT_EQ(table.times.size(), 601U);
  ExactSamples exact = exact_drive();
  for (std::size_t r = 0; r < table.times.size(); ++r) {
    const VectorXd y = exact.before(drive_load, table.times[r]);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(table.columns[k][r], y[static_cast<Eigen::Index>(k)], 1e-10) << table.times[r];
  }
}

Words steps(double motor, double load) {
  return {fmt::format("subsystems.motor.parameters.h={}", motor),
          fmt::format("subsystems.load.parameters.step={}", load)};
}

/// Of the drum's speed and of the twist: log2 of what halving all own steps gains.
DriveErrors orders_of(const Words& settings, double motor_step, double load_step) {
  DriveErrors e[2];
  for (const int k : {0, 1})
    e[k] = errors_of(
        rows_of("drive_libraries.toml", settings + steps(motor_step / (1 << k), load_step / (1 << k))));
  return {std::log2(e[0].drum_speed / e[1].drum_speed), std::log2(e[0].twist / e[1].twist)};
}

/// At an instant the voltage jumps, so the torque kinks. A load that leads goes on over h along the old
/// slope: its speed is off by some h², whatever the degree.
TEST(Drive, IsOfOrderTwoWhereTheLoadExtrapolatesTheTorqueWhichKinks) {
  for (const char* schedule : {"slowest-first", "parallel"})
    for (const char* how : {"lagrange1", "lagrange2", "lagrange3"}) {
      const DriveErrors order = orders_of(scheme(schedule, how), 1e-5, 1.25e-4);
      EXPECT_NEAR(order.drum_speed, 2.0, 0.2) << schedule << " " << how;
      EXPECT_NEAR(order.twist, 2.0, 0.2) << schedule << " " << how;
    }
}

/// Where the motor leads it extrapolates the speed, which bends: off by some h² over h. The load reads the
/// torque at places that are farther from the kink than polynomials of the motor's samples, 12 in h, reach.
TEST(Drive, IsOfOrderThreeWhereTheMotorExtrapolatesTheSpeedWhichBends) {
  const DriveErrors first = orders_of(scheme("fastest-first", "lagrange1"), 1e-5, 1.25e-4);
  EXPECT_NEAR(first.drum_speed, 2.0, 0.2);
  EXPECT_NEAR(first.twist, 2.0, 0.2);
  for (const char* how : {"lagrange2", "lagrange3"}) {
    const DriveErrors order = orders_of(scheme("fastest-first", how), 2.5e-6, 3.125e-5);
    EXPECT_NEAR(order.drum_speed, 3.0, 0.2) << how;
    EXPECT_NEAR(order.twist, 3.0, 0.2) << how;
  }
}

std::string text_of(const std::string& file, const Words& settings) {
  const Scratch folder;
  const Said said = tandem(folder, run_of(file, settings) + Words{"--no-reference"});
  EXPECT_EQ(said.status, 0) << said.err;
  return read_text(folder.path() / "o" / "results.csv");
}

TEST(Drive, HasTheSameBitsWithTheControllerInPythonAndInCpp) {
  for (const char* schedule : {"slowest-first", "fastest-first", "parallel"})
    EXPECT_EQ(text_of("drive.toml", scheme(schedule, "lagrange3")),
              text_of("drive_libraries.toml", scheme(schedule, "lagrange3")))
        << schedule;
}

/// The file with its tables from the last to the first.
std::string turned_round(const std::string& text) {
  std::string all;
  std::size_t end = text.size();
  for (std::size_t at; (at = text.rfind("\n[", end - 1)) != std::string::npos; end = at)
    all += text.substr(at, end - at);
  return text.substr(0, end) + all + "\n";
}

TEST(Drive, HasTheSameBitsInEachOrderOfItsFile) {
  const Scratch folder;
  const std::string file =
      folder.write("turned.toml", turned_round(read_text(drive_folder + "drive_libraries.toml"))).string();
  for (const char* schedule : {"slowest-first", "fastest-first", "parallel"}) {
    const Words settings = scheme(schedule, "lagrange3");
    const TimeTable plain = rows_of("drive_libraries.toml", settings);
    Words words = run_of("drive_libraries.toml",
                         settings + Words{"subsystems.load.source=diagram:" + drive_folder + "load.toml"});
    words[1] = file;
    const Said said = tandem(folder, words + Words{"--no-reference"});
    ASSERT_EQ(said.status, 0) << said.err;
    const TimeTable turned = TimeTable::read(folder.path() / "o");
    EXPECT_NE(turned.names, plain.names);
    EXPECT_EQ(turned.times, plain.times);
    for (const std::string& name : plain.names) EXPECT_EQ(column(turned, name), column(plain, name)) << name;
  }
}

TEST(Drive, TakesAnOrderOfThoseThatIntegrateThemselvesAndRefusesOneOfTheController) {
  const Words order{R"(coordination.order=["motor", "load"])"};
  EXPECT_EQ(text_of("drive_libraries.toml", scheme("slowest-first", "lagrange3") + order),
            text_of("drive_libraries.toml", scheme("fastest-first", "lagrange3")));
  const Scratch folder;
  const Said said = tandem(
      folder, run_of("drive_libraries.toml", {R"(coordination.order=["controller", "motor", "load"])"}));
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said.err, "'controller' is sampled")) << said.err;
}

/// 3e-4 s fit 8 times into a period: the load ends a step at 160 of the 240 instants, which are on no node of
/// its own, and has a row there.
TEST(Drive, EndsStepsAtInstantsOfTheControllerThatAreNoNodesOfItsOwn) {
  const Words settings = scheme("fastest-first", "lagrange3") + steps(2e-5, 3e-4);
  const TimeTable lands = rows_of("drive_libraries.toml", settings);
  const TimeTable goes_on = rows_of("drive_libraries.toml", settings + Words{"subsystems.load.land=never"});
  EXPECT_EQ(lands.times.size(), 1U + 2000U + 160U);
  EXPECT_EQ(goes_on.times.size(), 1U + 2000U);
  EXPECT_LT(errors_of(lands).drum_speed, 2e-5);
}

/// A diagram that is sampled wholly is a sampled subsystem like any other: it differs by rounding.
TEST(Drive, HasTheSameControllerAsADiagram) {
  for (const std::string schedule : {"slowest-first", "fastest-first", "parallel"}) {
    const Words settings = scheme(schedule, "lagrange3");
    const TimeTable expected = rows_of("drive_libraries.toml", settings),
                    rows = rows_of("drive_libraries.toml",
                                   settings + Words{"subsystems.controller.source=diagram:controller.toml",
                                                    "subsystems.controller.parameters={}"});
    ASSERT_EQ(rows.times, expected.times) << schedule;
    for (std::size_t c = 0; c < rows.columns.size(); ++c)
      for (std::size_t k = 0; k < rows.times.size(); ++k)
        ASSERT_NEAR(rows.columns[c][k], expected.columns[c][k],
                    1e-11 * std::max(1.0, std::abs(rows.columns[c][k])))
            << schedule << " at " << rows.times[k];
  }
}

/// A controller that is stepped like one that integrates itself.
Words of_steps(const std::string& schedule) {
  return scheme(schedule, "lagrange3") +
         Words{
             "subsystems.controller.command=[\"env\", \"PYTHONPATH=../../transports/python\", \"python3\", "
             "\"controller_of_steps.py\"]",
             "connections[motor.i_ref].reconstruction=lagrange0"};
}

TEST(Drive, AControllerThatIsSteppedIsRightWhereItFollowsAndWrongWhereItLeads) {
  const DriveErrors follows = errors_of(rows_of("drive.toml", of_steps("fastest-first")));
  const DriveErrors leads = errors_of(rows_of("drive.toml", of_steps("slowest-first")));
  EXPECT_LT(follows.drum_speed, 1e-5);
  EXPECT_GT(leads.drum_speed, 0.1);
}

/// The weight acts once, and stands still before and after; the run goes on.
TEST(Drive, ARunWithOneThatActsOnceTellsItsWholeTimeAndWritesCheckpointsToItsEnd) {
  const Scratch folder;
  const Words run = run_of("drive_mechanism.toml", {});
  Said said = tandem(folder, run + Words{"--checkpoint-every", "0.25"});
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_TRUE(contains(said.err, "0.6 s simulated")) << said.err;
  const std::string whole = read_text(folder.path() / "o" / "results.csv");
  said = tandem(folder, run + Words{"--resume", "o/checkpoint"});
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_TRUE(contains(said.out, "resumed at t = 0.5 s")) << said.out;
  EXPECT_EQ(read_text(folder.path() / "o" / "results.csv"), whole);
}

}  // namespace
}  // namespace tandem::test::drive
