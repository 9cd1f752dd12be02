// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "command.hpp"
#include "json_of.hpp"
#include "tandem/text/time_table.hpp"

namespace tandem {
namespace {

using test::json_of;
using test::read_text;
using test::Said;
using test::Scratch;
using test::tandem;
using test::two_mass_file;
using text::TimeTable;

TEST(RunCommand, WritesResultsWithUnitsAndMachineFigures) {
  const Scratch folder;
  const Said said = tandem(folder, {"run", two_mass_file("two_mass.toml")});
  ASSERT_EQ(said.status, 0) << said.err;
  const auto results = folder.path() / "results/two_mass";
  for (const char* name : {"results.csv", "results.json", "machine.json"})
    EXPECT_NE(said.out.find(std::string("wrote results/two_mass/") + name), std::string::npos) << said.out;
  EXPECT_EQ(TimeTable::read(results).times.size(), 10001U);
  const auto json = json_of(results / "results.json");
  EXPECT_EQ(json["status"], "ok");
  EXPECT_EQ(json["units"]["slow.v2"], "m/s");
  EXPECT_EQ(json["interpolation"]["fast.x1"], "own steps");
  EXPECT_EQ(json["interpolation"]["slow.x2"], "cubic hermite");
  EXPECT_EQ(json["scenario"]["values"]["span"]["stop"], 100.0);
  EXPECT_EQ(json["coordination"]["leader_first"][0], "slow");
  EXPECT_EQ(json["coordination"]["start"], "derivatives");
  EXPECT_EQ(json["reference"]["within"], true);
  EXPECT_TRUE(json["versions"].contains("tandem"));
  const auto machine = json_of(results / "machine.json");
  EXPECT_EQ(machine["subsystems"]["fast"]["steps"], 10000);
  EXPECT_EQ(machine["subsystems"]["slow"]["exchanges"], 400);
  EXPECT_GT(machine["real_time_factor"], 0.0);
  EXPECT_FALSE(machine["subsystems"]["fast"].contains("seconds"));
}

/// However short the run: simulated time, elapsed time and their ratio; times are in no file of results.
TEST(RunCommand, EndsWithALineOfItsRealTimeFactor) {
  const Scratch folder;
  const Said said = tandem(folder, {"run", two_mass_file("force_plain.toml"), "--no-reference"});
  ASSERT_EQ(said.status, 0) << said.err;
  double simulated = 0.0, elapsed = 0.0, factor = 0.0;
  const auto line = said.err.rfind(" s simulated in ");
  ASSERT_NE(line, std::string::npos) << said.err;
  const auto begin = said.err.rfind('\n', line) + 1;
  ASSERT_EQ(std::sscanf(said.err.c_str() + begin, "tandem: %lf s simulated in %lf s, %lf x real time",
                        &simulated, &elapsed, &factor),
            3)
      << said.err;
  EXPECT_EQ(simulated, 100.0);
  EXPECT_NEAR(factor * elapsed, simulated, 0.01 * simulated);  // three digits each
  EXPECT_FALSE(
      test::contains(tandem(folder, {"--quiet", "run", two_mass_file("force_plain.toml")}).err, "real time"));
}

TEST(RunCommand, ProfileGivesTheSecondsOfEachPart) {
  const Scratch folder;
  ASSERT_EQ(tandem(folder, {"run", two_mass_file("monolithic.toml"), "--profile", "--output", "o"}).status,
            0);
  const auto machine = json_of(folder.path() / "o/machine.json");
  EXPECT_GT(machine["subsystems"]["both"]["seconds"], 0.0);
  EXPECT_TRUE(machine["coordinator"].contains("seconds"));
}

TEST(RunCommand, OneThatDivergesEndsWithItsRowsKept) {
  const Scratch folder;
  const std::vector<std::string> words = {"run", two_mass_file("two_mass.toml"), "--no-reference", "--set",
                                          "parameters.frequency_ratio=120"};
  const Said said = tandem(folder, words);
  EXPECT_EQ(said.status, 1);
  EXPECT_TRUE(test::contains(said.err, "'slow' diverged: it gave v2 = ")) << said.err;
  const auto json = json_of(folder.path() / "results/two_mass/results.json");
  EXPECT_EQ(json["status"], "diverged");
  EXPECT_TRUE(test::contains(json["message"], "at t = 73.2 s; allowed is up to "));
  EXPECT_EQ(TimeTable::read(folder.path() / "results/two_mass").times.back(), 72.0);
  auto lifted = words;
  lifted.insert(lifted.end(), {"--set", "span.diverged_beyond=inf", "--output", "lifted"});
  EXPECT_EQ(tandem(folder, lifted).status, 0);
  EXPECT_EQ(json_of(folder.path() / "lifted/results.json")["status"], "ok");
  for (const char* wrong : {"1.0", "-3.0", "nan", "\"far\""}) {
    auto refused = words;
    refused.insert(refused.end(), {"--set", std::string("span.diverged_beyond=") + wrong});
    const Said answer = tandem(folder, refused);
    EXPECT_EQ(answer.status, 2) << wrong;
    EXPECT_TRUE(test::contains(answer.err, "a number above 1, or inf")) << answer.err;
  }
}

TEST(RunCommand, TwoRunsAreEqualToTheLastByte) {
  const Scratch folder;
  for (const char* name : {"a", "b"})
    ASSERT_EQ(
        tandem(folder, {"run", two_mass_file("force_plain.toml"), "--output", name, "--no-reference"}).status,
        0);
  for (const char* name : {"results.csv", "results.json"})
    EXPECT_EQ(read_text(folder.path() / "a" / name), read_text(folder.path() / "b" / name));
}

TEST(RunCommand, OverridesAreDoneAndRecorded) {
  const Scratch folder;
  const Said said = tandem(folder, {"run", two_mass_file("two_mass.toml"), "--no-reference", "--output", "o",
                                    "--set", "span.stop=2", "--set", "parameters.frequency_ratio=10", "--set",
                                    "connections.reconstruction=hermite", "--set",
                                    "record.ports=[\"slow.x2\"]", "--set", "record.clock=slow"});
  ASSERT_EQ(said.status, 0) << said.err;
  const TimeTable table = TimeTable::read(folder.path() / "o");
  EXPECT_EQ(table.names, std::vector<std::string>{"slow.x2"});
  EXPECT_EQ(table.times.size(), 21U);
  const auto scenario = json_of(folder.path() / "o/results.json")["scenario"];
  EXPECT_EQ(scenario["overrides"].size(), 5U);
  EXPECT_EQ(scenario["values"]["connections"][1]["reconstruction"], "hermite");
}

TEST(RunCommand, OwnClocksWriteAFileForEachSubsystem) {
  const Scratch folder;
  ASSERT_EQ(tandem(folder, {"run", two_mass_file("two_mass.toml"), "--no-reference", "--output", "o", "--set",
                            "record.clock=own"})
                .status,
            0);
  EXPECT_EQ(TimeTable::read(folder.path() / "o/results.fast.csv").times.size(), 10001U);
  EXPECT_EQ(TimeTable::read(folder.path() / "o/results.slow.csv").times.size(), 401U);
}

TEST(RunCommand, ADryRunWritesNothing) {
  const Scratch folder;
  const Said said = tandem(folder, {"run", two_mass_file("two_mass.toml"), "--dry-run"});
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "results"));
}

TEST(RunCommand, QuietPrintsNothing) {
  const Scratch folder;
  const Said said = tandem(folder, {"--quiet", "run", two_mass_file("two_mass.toml")});
  EXPECT_EQ(said.out + said.err, "");
}

TEST(RunCommand, TellsARunThatIsNotWithinItsReference) {
  const Scratch folder;
  const Said said = tandem(folder, {"run", two_mass_file("two_mass.toml"), "--set", "judge.tolerance=0.01"});
  EXPECT_EQ(said.status, 1);
  EXPECT_NE(said.err.find("fast.x1 differs by"), std::string::npos) << said.err;
  EXPECT_NE(said.err.find("tolerance 1 %"), std::string::npos) << said.err;
  const auto json = json_of(folder.path() / "results/two_mass/results.json");
  EXPECT_EQ(json["status"], "ok");
  EXPECT_EQ(json["reference"]["within"], false);
}

/// [judge] allows more of that column.
TEST(RunCommand, WhatTheReferenceAllowsHoldsForTheJudgedColumnToo) {
  const Scratch folder;
  const Said said =
      tandem(folder, {"run", two_mass_file("two_mass.toml"), "--set", "reference.tolerance=0.05"});
  EXPECT_EQ(said.status, 1);
  EXPECT_NE(said.err.find("tolerance 5 %"), std::string::npos) << said.err;
  EXPECT_EQ(json_of(folder.path() / "results/two_mass/results.json")["reference"]["within"], false);
}

TEST(RunCommand, RefusesAReferenceThatNothingRecordedCanBeComparedWith) {
  const Scratch folder;
  const std::string file = two_mass_file("two_mass.toml");
  Said said = tandem(folder, {"run", file, "--set", "record.clock=own"});
  EXPECT_EQ(said.status, 2);
  EXPECT_NE(said.err.find("record.clock is 'own'"), std::string::npos) << said.err;
  said = tandem(folder, {"run", file, "--set", "record.ports=[\"slow.x2\"]"});
  EXPECT_EQ(said.status, 2);
  EXPECT_NE(said.err.find("fast.x1 is not recorded"), std::string::npos) << said.err;
}

/// The broken loop of real_loop_memory diverges with half a kilogram until numbers are no longer finite.
TEST(RunCommand, ARunThatFailsKeepsItsResultsAndHasStatusOne) {
  const Scratch folder;
  const Said said = tandem(folder, {"run", two_mass_file("real_loop_memory.toml"), "--output", "o", "--set",
                                    "parameters.carried_mass=1.2", "--set", "span.stop=1000", "--set",
                                    "span.diverged_beyond=inf"});
  EXPECT_EQ(said.status, 1);
  EXPECT_NE(said.err.find("real_loop_memory.toml: subsystem"), std::string::npos) << said.err;
  EXPECT_NE(said.err.find("not finite at t = "), std::string::npos) << said.err;
  EXPECT_NE(said.err.find("kept in o"), std::string::npos) << said.err;
  EXPECT_GT(TimeTable::read(folder.path() / "o").times.size(), 1000U);
  const auto json = json_of(folder.path() / "o/results.json");
  EXPECT_EQ(json["status"], "failed");
  EXPECT_NE(json["message"].get<std::string>().find("not finite"), std::string::npos);
}

TEST(RunCommand, AFolderThatCannotBeMadeIsStatusTwo) {
  const Scratch folder;
  const Said said = tandem(folder, {"run", two_mass_file("two_mass.toml"), "--output", "/dev/null/o"});
  EXPECT_EQ(said.status, 2);
  EXPECT_NE(said.err.find("'/dev/null/o'"), std::string::npos) << said.err;
}

TEST(RunCommand, ADryRunRefusesAFolderThatCannotBeMade) {
  const Scratch folder;
  folder.write("file", "");
  for (const char* output : {"file", "file/o"}) {
    const Said said =
        tandem(folder, {"run", two_mass_file("two_mass.toml"), "--dry-run", "--output", output});
    EXPECT_EQ(said.status, 2) << output;
    EXPECT_NE(said.err.find("'" + std::string(output) + "'"), std::string::npos) << said.err;
  }
}

TEST(RunCommand, VerboseAndTheLogTellWhatIsDone) {
  const Scratch folder;
  const std::string file = two_mass_file("two_mass.toml");
  Said said = tandem(folder, {"--verbose", "run", file});
  EXPECT_NE(said.err.find("subsystem 'slow': first own step 0.25 s"), std::string::npos) << said.err;
  EXPECT_NE(said.err.find("schedule slowest-first, start derivatives"), std::string::npos) << said.err;
  said = tandem(folder, {"--log", "l.log", "run", file});
  EXPECT_EQ(std::count(said.err.begin(), said.err.end(), '\n'), 1) << said.err;  // the real-time factor
  EXPECT_NE(read_text(folder.path() / "l.log").find("first own step 0.25 s"), std::string::npos);
  said = tandem(folder, {"--log", "l.log", "run", file, "--set", "judge.tolerance=0.01"});
  EXPECT_NE(read_text(folder.path() / "l.log").find("fast.x1 differs by"), std::string::npos);
  said = tandem(folder, {"--log", "/dev/full", "run", file});
  EXPECT_EQ(said.status, 1);
  EXPECT_NE(said.err.find("log file '/dev/full' can't be written"), std::string::npos) << said.err;
  EXPECT_EQ(tandem(folder, {"--log", "/dev/null/l", "run", file}).status, 2);
}

}  // namespace
}  // namespace tandem
