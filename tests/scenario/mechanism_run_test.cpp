// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Mechanisms from the command line: alone, with data from a file, with bad input.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "command.hpp"
#include "mechanisms/pendulum.hpp"
#include "tandem/mbs/sparse/matrix_file.hpp"
#include "tandem/text/time_table.hpp"

namespace tandem {
namespace {

using test::Said;
using test::Scratch;
using test::tandem;
using text::TimeTable;

std::string mechanism_file(const std::string& name) {
  return std::string(TANDEM_SOURCE_DIR) + "/scenarios/mechanisms/" + name + "/" + name + ".toml";
}

const std::vector<double>& column(const TimeTable& table, const std::string& name) {
  const auto it = std::find(table.names.begin(), table.names.end(), name);
  EXPECT_NE(it, table.names.end()) << name;
  return table.columns[static_cast<std::size_t>(it - table.names.begin())];
}

TEST(RunCommand, RunsAMechanismAloneAndWritesWhereItsPointsAre) {
  const Scratch folder;
  const Said said =
      tandem(folder, {"run", mechanism_file("pendulum"), "--set", "run.stop=1", "--output", "o"});
  ASSERT_EQ(said.status, 0) << said.err;
  const TimeTable table = TimeTable::read(folder.path() / "o");
  ASSERT_EQ(table.times.size(), 1001U);
  const auto truth = mechanisms::pendulum(1.0);
  EXPECT_NEAR(column(table, "pendulum.P.x").back(), truth.tip[0], 1e-5);
  EXPECT_NEAR(column(table, "pendulum.pin_y").back(), truth.reaction[1], 1e-3);
  EXPECT_EQ(column(table, "pendulum.O.x").back(), 0.0);
}

TEST(RunCommand, RunsEveryMechanismOfTheRepository) {
  const Scratch folder;
  for (const char* name :
       {"pendulum", "double_pendulum", "spherical_pendulum", "slider_crank", "spring_pendulum", "four_bar",
        "andrews", "bricard", "rotor", "asymmetric_rotor", "spatial_slider_crank"}) {
    const Said said =
        tandem(folder, {"run", mechanism_file(name), "--set", "run.stop=0.01", "--output", name});
    EXPECT_EQ(said.status, 0) << name << ": " << said.err;
  }
}

/// Bricard's mechanism has one equation that the others imply; the planar linkage has none.
TEST(RunCommand, TellsWhichEquationsAreRedundant) {
  const Scratch folder;
  const auto notes = [&](const std::string& name) {
    const Said said =
        tandem(folder, {"run", mechanism_file(name), "--set", "run.stop=0.01", "--output", name});
    EXPECT_EQ(said.status, 0) << said.err;
    return test::read_text(folder.path() / name / "results.json");
  };
  const std::string bricard = notes("bricard");
  EXPECT_NE(bricard.find("subsystem 'bricard': 1 redundant equation: body rod"), std::string::npos);
  EXPECT_EQ(notes("four_bar").find("redundant"), std::string::npos);
}

TEST(RunCommand, AForceComesFromADataFile) {
  const Scratch folder;
  folder.write("push.csv", "time,F\n0,0\n0.5,4\n1,0\n");
  folder.write("m.toml",
               "dimension = 2\n[points]\nP = { at = [0, 0] }\n[masses]\nm = { point = 'P', mass = 2 }\n"
               "[inputs]\nF = { unit = 'N', file = 'push.csv', column = 'F' }\n"
               "[forces]\nf = { point = 'P', direction = [1, 0], magnitude = 'F' }\n"
               "[outputs]\nv = { velocity = 'P.x' }\n[run]\nstop = 1\nstep = 0.01\n");
  const Said said = tandem(folder, {"run", "m.toml", "--output", "o"});
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_NEAR(column(TimeTable::read(folder.path() / "o"), "m.v").back(), 1.0, 1e-12);  // 2 N s on 2 kg
  const Said beyond = tandem(folder, {"run", "m.toml", "--set", "run.stop=1.2", "--output", "p"});
  EXPECT_EQ(beyond.status, 1);
  EXPECT_NE(beyond.err.find("column 'F' of"), std::string::npos) << beyond.err;
  EXPECT_NE(beyond.err.find("beyond = \"refuse\" says that nothing is known there"), std::string::npos)
      << beyond.err;
  EXPECT_GT(TimeTable::read(folder.path() / "p").times.size(), 90U)
      << "results up to the last exchange are kept";
}

TEST(RunCommand, DumpsTheMatricesOfAMechanism) {
  const Scratch folder;
  const Said said = tandem(folder, {"run", mechanism_file("spring_pendulum"), "--set", "run.stop=0.5",
                                    "--output", "o", "--dump-matrices", "m", "--dump-at", "0,0.25"});
  ASSERT_EQ(said.status, 0) << said.err;
  for (const char* name : {"mass", "jacobian", "stiffness", "damping", "tangent"})
    for (const char* at : {"_0.mtx", "_0.25.mtx"})
      EXPECT_NO_THROW(
          mbs::read_matrix_market(folder.path() / "m" / "spring_pendulum" / (std::string(name) + at)));
  const Said none = tandem(folder, {"run", test::two_mass_file("two_mass.toml"), "--dump-matrices", "m"});
  EXPECT_EQ(none.status, 2);
  EXPECT_NE(none.err.find("no subsystem of the scenario has the source mechanism:FILE"), std::string::npos);
}

TEST(RunCommand, RefusesTimesOfMatricesThatAreNone) {
  const Scratch folder;
  const auto dump = [&](const std::string& into, const std::string& at) {
    return tandem(folder,
                  {"run", mechanism_file("spring_pendulum"), "--dump-matrices", into, "--dump-at", at});
  };
  for (const char* none : {"", "x", "nan", "0,", ",0", "0,,0.1", "0 ", "1e400"}) {
    const Said said = dump("m", none);
    EXPECT_EQ(said.status, 2) << none;
    EXPECT_NE(said.err.find(std::string("--dump-at is '") + none + "', of which '"), std::string::npos)
        << said.err;
    EXPECT_NE(said.err.find("allowed are times in s with a comma between, as 0,0.5"), std::string::npos)
        << said.err;
  }
  const Said beyond = dump("m", "0,1e9");
  EXPECT_EQ(beyond.status, 2);
  EXPECT_NE(beyond.err.find("--dump-at: 1000000000 s is outside the run"), std::string::npos) << beyond.err;
  const Said nowhere = dump("", "0");
  EXPECT_EQ(nowhere.status, 2);
  EXPECT_NE(nowhere.err.find("--dump-matrices is ''; allowed is the name of a folder"), std::string::npos)
      << nowhere.err;
}

/// Arguments after the file, and words of the sentence.
struct BadArguments {
  std::vector<std::string> arguments, words;
};

TEST(RunCommand, RefusesWhatAMechanismCanNotDo) {
  const Scratch folder;
  const BadArguments list[] = {
      {{"--set", "run.formulation=index4"}, {"'index4'", "index3"}},
      {{"--set", "run.integrator=rk4"}, {"index3 has Newmark's method merged in"}},
      {{"--set", "run.formulation='index3'", "--set", "run.beta=0.3"},
       {"--set run.beta=0.3: ", "beta is 0.3"}},
      {{"--set", "run.step=-1"}, {"step is -1 s", "above 0"}},
      {{"--set", "run.solver=cluck"}, {"'cluck'", "klu"}},
      {{"--set", "run.penality=1"}, {"'penality'", "did you mean 'penalty'?"}},
      {{"--set", "run.most_iterations=2.5"}, {"'most_iterations' is 2.5", "whole number"}},
      {{"--set", "run.most_iterations=3000000000"}, {"3000000000", "from 1 to 1000000000"}},
      {{"--set", "run.threads=257"}, {"'threads' is 257", "from 1 to 256"}},
      {{"--set", "run.threads_from=0"}, {"'threads_from' is 0", "a whole number from 1"}},
      {{"--set", "run.penalty=0"}, {"'penalty' is 0", "above 0, or to leave it out"}},
      {{"--set", "run.step=1000"}, {"run.step is the number 1000", "from run.start to run.stop"}},
      {{"--set", "gravity=3"},
       {"--set gravity=3: gravity is the number 3; allowed is an array of 2 numbers"}},
      {{"--set", "rods.rodd.mass=1"}, {"--set rods.rodd.mass=1: table of [rods] 'rodd' is not there"}},
      {{"--set", "run.stop=-3"}, {"run.stop", "-3"}},
      {{"--set", "run.matrices_at='0'"}, {"'matrices_at' is given without 'matrices'"}}};
  for (const BadArguments& bad : list) {
    std::vector<std::string> arguments = {"run", mechanism_file("pendulum")};
    arguments.insert(arguments.end(), bad.arguments.begin(), bad.arguments.end());
    const Said said = tandem(folder, arguments);
    EXPECT_EQ(said.status, 2) << said.err;
    for (const std::string& word : bad.words)
      EXPECT_NE(said.err.find(word), std::string::npos) << word << " in: " << said.err;
  }
}

TEST(RunCommand, AFileThatHoldsNothingIsToldOfTheKinds) {
  const Scratch folder;
  for (const char* text : {"", "\n", "# a mechanism, some day\n"}) {
    folder.write("m.toml", text);
    for (const char* command : {"run", "info", "validate"}) {
      const Said said = tandem(folder, {command, "m.toml"});
      EXPECT_EQ(said.status, 2);
      EXPECT_NE(said.err.find("m.toml: the file holds nothing; allowed is a scenario, with tables "
                              "[subsystems.NAME], a mechanism, with points, or a diagram, with blocks"),
                std::string::npos)
          << said.err;
    }
  }
}

TEST(RunCommand, AMechanismWithoutAStopIsToldOfIt) {
  const Scratch folder;
  folder.write("m.toml",
               "dimension = 2\n[points]\nP = { at = [0, 0] }\n[masses]\nm = { point = 'P', mass = 2 }\n"
               "[run]\nstep = 0.1\n");
  const Said said = tandem(folder, {"run", "m.toml"});
  EXPECT_EQ(said.status, 2);
  EXPECT_NE(said.err.find("m.toml:6: run.stop is missing"), std::string::npos) << said.err;
}

TEST(RunCommand, AMechanismInAScenarioIsLookedForBesideIt) {
  const Scratch folder;
  folder.write(
      "m.toml",
      "dimension = 2\n[points]\nP = { at = [0, 0] }\n[masses]\nm = { point = 'P', mass = 2 }\n"
      "[inputs]\nF = { unit = 'N' }\n[forces]\nf = { point = 'P', direction = [1, 0], magnitude = 'F' }\n"
      "[outputs]\nv = { velocity = 'P.x' }\n");
  folder.write("s.toml",
               "[subsystems.m]\nsource = 'mechanism:m.toml?step=0.1'\n[subsystems.m.inputs]\nF = "
               "4\n[span]\nstop = 1\n");
  const Said said = tandem(folder, {"run", "s.toml", "--output", "o"});
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_NEAR(column(TimeTable::read(folder.path() / "o"), "m.v").back(), 2.0, 1e-12);
}

}  // namespace
}  // namespace tandem
