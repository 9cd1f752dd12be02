// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "command.hpp"
#include "json_of.hpp"
#include "sources/all.hpp"
#include "tandem/error.hpp"
#include "tandem/scenario/run.hpp"
#include "tandem/text/time_table.hpp"

namespace tandem::test::run_indicators {
namespace {

using scenario::Assembly;
using scenario::Scenario;

const std::string scenes = std::string(TANDEM_SOURCE_DIR) + "/scenarios/";

/// Energy of two oscillators joined by a spring, at the last row.
double energy(const Assembly& run) {
  const auto newest = [&](int who) {
    const History& history = run.coordinator().exchange().history(who);
    return history.values(history.newest());
  };
  const auto a = newest(0), b = newest(1);
  return 0.5 * (a[0] * a[0] + a[1] * a[1] + b[0] * b[0] + b[1] * b[1] + (a[0] - b[0]) * (a[0] - b[0]));
}

/// Sides that are exact for the inputs that they use: what the energy of both has changed by is the coupling's. Ten steps of
/// one in a step of the other. (Where the follower interpolates by a cubic, the indicator takes that for the motion.)
TEST(RunIndicators, EnergyOfALinkIsWhatTheEnergyOfBothChangesBy) {
  const Builtins builtins = all_sources();
  for (const std::string schedule : {"slowest-first", "fastest-first", "parallel"})
    for (const std::string how : {"lagrange1", "lagrange2", "lagrange3", "hermite"}) {
      if (schedule == "slowest-first" && how != "lagrange1") continue;
      const Scenario scene =
          scenario::read(scenes + "oscillator/displacement_displacement.toml",
                         {"constants.d=0", "constants.d1=0", "constants.d2=0", "span.stop=6",
                          "coordination.schedule=" + schedule, "connections.reconstruction=" + how,
                          "subsystems.side2.parameters.step=0.02", "subsystems.side1.parameters.step=0.2"});
      Assembly run(scene, builtins);
      const auto indicators = run.indicators();
      run.coordinator().observe(indicators.get());
      run.initialize();
      const double before = energy(run);
      while (run.coordinator().round()) {
      }
      const double made = energy(run) - before;
      ASSERT_EQ(indicators->links().size(), 1U);
      EXPECT_NEAR(indicators->links()[0].energy, made, 0.02 * std::abs(made) + 1e-8)
          << schedule << ' ' << how;
    }
}

TEST(RunIndicators, ChangeNoBitOfTheResults) {
  for (const char* file : {"two_mass/two_mass.toml", "drive/drive.toml", "kart/kart.toml",
                           "engine_linkage/engine_linkage.toml"}) {
    const Scratch folder;
    const auto run = [&](const std::string& to, const std::string& what) {
      EXPECT_EQ(tandem(folder, {"run", scenes + file, "--no-reference", "--output", to, "--set",
                                "record.indicators=" + what, "--set", "span.stop=1"})
                    .status,
                0);
      return read_text(folder.path() / to / "results.csv");
    };
    EXPECT_EQ(run("with", "raw"), run("without", "off")) << file;
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "with/indicators.csv"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "without/indicators.csv"));
    EXPECT_EQ(run("with", "off"), run("without", "off"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "with/indicators.csv")) << "of an earlier run";
  }
}

TEST(RunIndicators, StandInTheLastLineInAFileAndInTheResults) {
  const Scratch folder;
  const Said said = tandem(folder, {"run", scenes + "drive/drive.toml", "--output", "o"});
  EXPECT_NE(said.out.find("indicators: largest defect "), std::string::npos) << said.out;
  EXPECT_NE(said.out.find(" J that passed (motor.torque:load.speed)"), std::string::npos) << said.out;
  const auto table = text::TimeTable::read(folder.path() / "o/indicators.csv");
  const std::vector<std::string> names{"defect(load.torque)", "defect(motor.w)", "defect(controller.w)",
                                       "energy(motor.torque:load.speed)"};
  EXPECT_EQ(table.names, names);
  const auto about = json_of(folder.path() / "o/results.json");
  EXPECT_NEAR(about["indicators"]["energies"][names[3]]["made"], table.columns[3].back(), 1e-15)
      << "another sum";
  EXPECT_EQ(about["units"][names[1]], "rad/s");
}

TEST(RunIndicators, GoOnFromACheckpointWithTheSameBytes) {
  const Scratch folder;
  const std::vector<std::string> whole{"run", scenes + "drive/drive.toml", "--output", "whole"};
  EXPECT_EQ(tandem(folder, whole).status, 0);
  EXPECT_EQ(
      tandem(folder, {"run", scenes + "drive/drive.toml", "--output", "cut", "--checkpoint-every", "0.25"})
          .status,
      0);
  const std::string file = folder.path() / "cut/indicators.csv";
  std::filesystem::remove(file);
  EXPECT_EQ(tandem(folder, {"run", scenes + "drive/drive.toml", "--output", "cut", "--resume",
                            "cut/checkpoint", "--checkpoint-every", "0.25"})
                .status,
            0);
  EXPECT_EQ(read_text(file), read_text(folder.path() / "whole/indicators.csv"));
}

std::string refusal_of(const std::string& links) {
  const Scratch folder;
  std::ofstream(folder.path() / "s.toml") << read_text(scenes + "two_mass/two_mass.toml") << "\n[[links]]\n"
                                          << links;
  const Said said = tandem(folder, {"validate", "s.toml"});
  EXPECT_EQ(said.status, 2) << said.out;
  return said.err;
}

/// The load ends no step at the instants, so the controller reads the line through its newest two rows. What its speed was
/// there is the cubic of the rows beside it.
TEST(RunIndicators, TheDefectOfASampledReaderIsWhatItsInputMissed) {
  const Scratch folder;
  const Said said =
      tandem(folder, {"run", scenes + "drive/drive_libraries.toml", "--no-reference", "--output", "o",
                      "--set", "subsystems.load.parameters.step=7e-4", "--set", "subsystems.load.land=never",
                      "--set", "connections[controller.w].reconstruction=lagrange1", "--set",
                      "record.clock=own", "--set", "record.derivatives=true"});
  ASSERT_EQ(said.status, 0) << said.err;
  const auto rows = text::TimeTable::read(folder.path() / "o/results.load.csv");
  const auto column = [&](const std::string& name) -> const std::vector<double>& {
    return rows.columns.at(
        static_cast<std::size_t>(std::find(rows.names.begin(), rows.names.end(), name) - rows.names.begin()));
  };
  const auto &y = column("load.speed"), &slope = column("der(load.speed)"), &t = rows.times;
  double largest = 0.0, at = 0.0;
  std::size_t next = 0;
  for (int k = 1; k < 240; ++k) {
    const double instant = k * 2.5e-3;
    while (t[next] <= instant + 1e-12) ++next;
    if (next < 3) continue;
    const double line =
        y[next - 1] + (y[next - 1] - y[next - 2]) / (t[next - 1] - t[next - 2]) * (instant - t[next - 1]);
    const double h = t[next] - t[next - 1], s = (instant - t[next - 1]) / h;
    const double cubic = y[next - 1] * (1 + 2 * s) * (1 - s) * (1 - s) +
                         h * slope[next - 1] * s * (1 - s) * (1 - s) + y[next] * s * s * (3 - 2 * s) +
                         h * slope[next] * s * s * (s - 1);
    if (std::abs(line - cubic) > largest) largest = std::abs(line - cubic), at = instant;
  }
  const auto told =
      json_of(folder.path() / "o/results.json")["indicators"]["defects"]["defect(controller.w)"];
  EXPECT_GT(largest, 0.05);
  EXPECT_NEAR(told["largest"].get<double>(), largest, 1e-9 * largest);
  EXPECT_NEAR(told["at"].get<double>(), at, 1e-12);
}

TEST(RunIndicators, LinksThatAreNoneAreRefused) {
  EXPECT_NE(refusal_of("effort = 'slow.x2'\n").find("flow"), std::string::npos);
  EXPECT_NE(refusal_of("flow = 'slow.x2'\n").find("effort"), std::string::npos);
  EXPECT_NE(refusal_of("effort = 'slow.x2'\nflow = 'fast.x1'\n").find("make no power"), std::string::npos);
  EXPECT_NE(refusal_of("effort = 'slow.x9'\nflow = 'fast.x1'\n").find("slow.x2"), std::string::npos);
  EXPECT_NE(refusal_of("effort = 'slow.v2'\nflow = 'fast.x1'\n").find("not read"), std::string::npos);
  EXPECT_NE(refusal_of("displacement = 'slow.x2'\nstiffness = 1\n").find("two outputs"), std::string::npos);
  EXPECT_NE(refusal_of("displacement = ['slow.x2', 'fast.x1']\nstiffness = -1\n").find("above 0"),
            std::string::npos);
}

}  // namespace
}  // namespace tandem::test::run_indicators
