// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// scenarios/drive: a motor in C, a load that twists, and a speed controller that samples, against the exact
// motion.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "command.hpp"
#include "drive_scene.hpp"
#include "tandem/text/time_table.hpp"

namespace tandem::test {
namespace {

using Words = std::vector<std::string>;
using text::TimeTable;

const std::string drive_folder = TANDEM_SOURCE_DIR "/scenarios/drive/";

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
  for (const Words& all : {libraries_of(file), settings})
    for (const std::string& s : all) words.insert(words.end(), {"--set", s});
  return words;
}

/// What it gives at all steps of the load.
TimeTable rows_of(const std::string& file, const Words& settings) {
  const Scratch folder;
  Words words = run_of(file, settings);
  words.push_back("--no-reference");
  const Said said = tandem(folder, words);
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

/// log2 of what halving all own steps gains, of drum speed and twist.
DriveErrors orders(const Words& settings, double motor_step, double load_step) {
  DriveErrors e[2];
  for (int k = 0; k < 2; ++k) {
    Words all = settings;
    all.push_back("subsystems.motor.parameters.h=" + fmt::format("{}", motor_step / (1 << k)));
    all.push_back("subsystems.load.parameters.step=" + fmt::format("{}", load_step / (1 << k)));
    e[k] = errors_of(rows_of("drive_libraries.toml", all));
    std::printf("%s %s %g: %.3e %.3e\n", settings[0].c_str(), settings[1].c_str(), load_step / (1 << k),
                e[k].drum_speed, e[k].twist);
  }
  return {std::log2(e[0].drum_speed / e[1].drum_speed), std::log2(e[0].twist / e[1].twist)};
}

TEST(Drive, Orders) {
  for (const char* schedule : {"slowest-first", "fastest-first", "parallel"})
    for (const char* how : {"lagrange0", "lagrange1", "lagrange2", "lagrange3"})
      for (double s : {4.0, 2.0, 1.0}) {
        const auto o = orders(scheme(schedule, how), 1.6e-5 * s, 1e-4 * s);
        std::printf("   orders %.2f %.2f\n", o.drum_speed, o.twist);
      }
}

}  // namespace
}  // namespace tandem::test
