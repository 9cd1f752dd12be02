// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <stdlib.h>  // setenv

#include <algorithm>
#include <filesystem>

#include "command.hpp"

namespace tandem::test {
namespace {

/// A run of the FMU `faulty` and of one that reads it, with temporary files in a folder of its own; `isolation`: lines of the subsystem.
struct FaultyRun {
  explicit FaultyRun(int how, const std::string& isolation = "", const std::string& stop = "1") {
    folder.write("s.toml", "[subsystems.one]\nsource = \"fmu:" TANDEM_FMUS "/faulty.fmu\"\n" + isolation +
                               "parameters.set = { how = " + std::to_string(how) +
                               " }\n[subsystems.two]\nsource = \"fmu:" TANDEM_FMUS
                               "/mass.fmu?step=0.1\"\n[[connections]]\nfrom = \"one.x\"\nto = \"two.u\"\n"
                               "reconstruction = \"lagrange1\"\n[span]\nstop = " +
                               stop + "\n");
    std::filesystem::create_directories(folder.path() / "temporary");
    ::setenv("TMPDIR", (folder.path() / "temporary").c_str(), 1);
    said = tandem(folder, {"--quiet", "run", "s.toml", "--output", "r"});
    ::unsetenv("TMPDIR");
  }
  /// Those before the fault.
  bool keeps_rows() const { return contains(read_text(folder.path() / "r/results.csv"), "\n0.4,0.656"); }

  bool says_no_more_than(int sentences) const {
    return std::count(said.err.begin(), said.err.end(), '\n') <= sentences;
  }

  bool leaves_nothing() const { return std::filesystem::is_empty(folder.path() / "temporary"); }

  Scratch folder;
  Said said;
};

const std::string isolated = "isolate = true\nparameters.deadline = 0.5\n";

TEST(FmuFaults, AFaultIsOneSentenceAndTheRowsAreKept) {
  for (const std::string isolation : {"", "isolate = true\n"}) {
    const FaultyRun run(1, isolation);
    EXPECT_NE(run.said.status, 0);
    EXPECT_TRUE(contains(run.said.err, "reached for memory that is not there")) << run.said.err;
    EXPECT_TRUE(run.says_no_more_than(1)) << run.said.err;
    EXPECT_TRUE(run.keeps_rows()) << isolation << run.said.err;
    EXPECT_TRUE(run.leaves_nothing());
  }
}

TEST(FmuFaults, AStepWithoutEndEndsTheRunWhereTheFmuIsIsolated) {
  const FaultyRun run(2, isolated);
  EXPECT_NE(run.said.status, 0);
  EXPECT_TRUE(contains(run.said.err, "0.5 s")) << run.said.err;
  EXPECT_TRUE(run.says_no_more_than(1)) << run.said.err;
  EXPECT_TRUE(run.keeps_rows() && run.leaves_nothing());
}

TEST(FmuFaults, AnExitIsOneSentence) {
  for (const std::string isolation : {"", "isolate = true\n"}) {
    const FaultyRun run(4, isolation);
    EXPECT_NE(run.said.status, 0);
    EXPECT_TRUE(contains(run.said.err, isolation.empty()
                                           ? "it ended the program; allowed is to return"
                                           : "was ended by a library in the middle of the work"))
        << run.said.err;
    EXPECT_TRUE(run.says_no_more_than(1)) << run.said.err;
    EXPECT_TRUE(run.keeps_rows()) << isolation << run.said.err;
  }
}

TEST(FmuFaults, WhatItPrintsHarmsNothing) {
  for (const std::string isolation : {"", "isolate = true\n"}) {
    const FaultyRun run(3, isolation);
    EXPECT_EQ(run.said.status, 0) << run.said.err;
    EXPECT_TRUE(run.keeps_rows());
  }
}

/// All others would go by it.
TEST(FmuFaults, AnotherWayOfRoundingEndsTheRun) {
  const FaultyRun here(5), apart(5, "isolate = true\n");
  EXPECT_EQ(here.said.status, 1);
  EXPECT_TRUE(contains(here.said.err, "it changed how numbers are rounded")) << here.said.err;
  EXPECT_TRUE(here.keeps_rows());
  EXPECT_TRUE(contains(apart.said.err, "it changed how numbers are rounded")) << apart.said.err;
}

/// Sums of its own steps may round to one step more; a step that it does not do is another thing.
TEST(FmuFaults, ATimeThatIsAStepAheadAfterManyThatWereRightIsTold) {
  const FaultyRun ahead(6, "", "30"), stands(7, "", "30");
  EXPECT_EQ(ahead.said.status, 0) << ahead.said.err;
  const Said told = tandem(ahead.folder, {"run", "s.toml", "--output", "r"});
  EXPECT_TRUE(contains(told.err, "its own time is 20.1")) << told.err;
  EXPECT_EQ(stands.said.status, 1);
  EXPECT_TRUE(contains(stands.said.err, "but its own time is 20 s")) << stands.said.err;
}

/// The system has no room for the library.
TEST(FmuFaults, AFullDiskWhileItIsUnpackedIsOneSentenceAndNothingIsLeft) {
  const Scratch folder;
  folder.write("s.toml", "[subsystems.one]\nsource = \"fmu:" TANDEM_FMUS "/faulty.fmu\"\n[span]\nstop = 1\n");
  std::filesystem::create_directories(folder.path() / "temporary");
  const std::string line = "cd " + shell_quoted(folder.path().string()) +
                           " && ulimit -f 8 && trap '' XFSZ && TMPDIR=temporary '" TANDEM_COMMAND
                           "' --quiet run s.toml --output r > out.txt 2> err.txt";
  const int status = std::system(line.c_str());
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) != 0);
  const std::string said = read_text(folder.path() / "err.txt");
  EXPECT_TRUE(contains(said, "faulty.so")) << said;
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  EXPECT_TRUE(std::filesystem::is_empty(folder.path() / "temporary"));
}

}  // namespace
}  // namespace tandem::test
