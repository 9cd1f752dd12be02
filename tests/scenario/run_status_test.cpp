// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What results.json says of a run that does not come to its end.
#include <gtest/gtest.h>

#include <csignal>

#include "background.hpp"
#include "command.hpp"
#include "json_of.hpp"
#include "tandem/text/time_table.hpp"

namespace tandem::test {
namespace {

/// A run is killed in a folder that holds the results of one that was ok.
TEST(RunStatus, WhatAKilledRunLeavesIsNotOk) {
  const Scratch folder;
  const auto output = folder.path() / "o";
  ASSERT_EQ(tandem(folder, {"run", two_mass_file("two_mass.toml"), "--no-reference", "--output", "o"}).status,
            0);
  ASSERT_EQ(json_of(output / "results.json")["status"], "ok");
  std::filesystem::remove(output / "results.csv");
  Background run(folder, {"run", two_mass_file("two_mass.toml"), "--no-reference", "--output", "o", "--set",
                          "span.stop=1e9"});
  ASSERT_TRUE(run.wait_for_file(output / "results.csv")) << run.err();
  run.end_by(SIGKILL);
  const auto about = json_of(output / "results.json");
  EXPECT_EQ(about["status"], "running");
  EXPECT_EQ(about["files"][0], "results.csv");
  EXPECT_FALSE(std::filesystem::exists(output / "machine.json"));
  const std::string sentence = "is of a run that did not come to its end: running, process ";
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"compare", "o", "o"}, {"compare", "o/results.csv", "o"}, {"view", "o"}})
    EXPECT_NE(tandem(folder, words).err.find(sentence), std::string::npos) << words[0];
  const Said said = tandem(folder, {"run", two_mass_file("two_mass.toml"), "--output", "p", "--set",
                                    "reference.file=" + (output / "results.csv").string()});
  EXPECT_EQ(said.status, 2);
  EXPECT_NE(said.err.find(sentence), std::string::npos) << said.err;
  std::filesystem::create_symlink(output / "results.csv", folder.path() / "link.csv");
  for (const char* file : {"o", "o/results.csv", "link.csv"}) {
    folder.write("study.toml",
                 "scenario = '" + two_mass_file("two_mass.toml") +
                     "'\ncolumns = ['stop']\n[set]\n'span.stop' = '$stop'\n"
                     "[[tables.t.blocks]]\naxes = [{ stop = [0.1] }]\n[references.r]\nfile = '" +
                     file + "'\n[metrics]\ne = { of = 'fast.x1' }\n");
    const Said swept = tandem(folder, {"sweep", "study.toml", "--output", "t"});
    EXPECT_EQ(swept.status, 2) << file;
    EXPECT_NE(swept.err.find("study.toml:7: reference r: "), std::string::npos) << swept.err;
    EXPECT_NE(swept.err.find(sentence), std::string::npos) << swept.err;
  }
}

/// A run that would take hours, interrupted as soon as its results file is there.
TEST(RunStatus, CtrlCEndsCleanlyAndKeepsResults) {
  const Scratch folder;
  const auto output = folder.path() / "o";
  Background run(folder, {"run", two_mass_file("two_mass.toml"), "--no-reference", "--output", "o", "--set",
                          "span.stop=1e9"});
  ASSERT_TRUE(run.wait_for_file(output / "results.csv")) << run.err();
  EXPECT_EQ(run.end_by(SIGINT), 1);
  EXPECT_NE(run.err().find("interrupted at t = "), std::string::npos) << run.err();
  EXPECT_EQ(json_of(output / "results.json")["status"], "interrupted");
  EXPECT_GT(text::TimeTable::read(output).times.size(), 1000U);
}

TEST(RunStatus, AHangUpEndsCleanly) {
  const Scratch folder;
  Background run(folder, {"run", two_mass_file("two_mass.toml"), "--no-reference", "--output", "o", "--set",
                          "span.stop=1e9"});
  ASSERT_TRUE(run.wait_for_file(folder.path() / "o/results.csv")) << run.err();
  EXPECT_EQ(run.end_by(SIGHUP), 1);
  EXPECT_EQ(json_of(folder.path() / "o/results.json")["status"], "interrupted");
}

}  // namespace
}  // namespace tandem::test
