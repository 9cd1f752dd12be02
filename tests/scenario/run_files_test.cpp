// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The files of a run: on a full disk, in numpy's format, and of a process that is killed.
#include <gtest/gtest.h>

#include "background.hpp"
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

TEST(RunCommand, AFullDiskIsToldWithStatusOne) {
  const Scratch folder;
  std::filesystem::create_directory(folder.path() / "o");
  std::filesystem::create_symlink("/dev/full", folder.path() / "o/results.csv");
  Said said = tandem(folder, {"run", two_mass_file("two_mass.toml"), "--output", "o"});
  EXPECT_EQ(said.status, 1);
  EXPECT_NE(said.err.find("'o/results.csv' can't be written: No space left on device"), std::string::npos)
      << said.err;
  EXPECT_EQ(json_of(folder.path() / "o/results.json")["status"], "failed");

  std::filesystem::remove(folder.path() / "o/results.csv");
  std::filesystem::remove(folder.path() / "o/results.json");
  std::filesystem::create_symlink("/dev/full", folder.path() / "o/results.json");
  said = tandem(folder, {"run", two_mass_file("two_mass.toml"), "--output", "o"});
  EXPECT_EQ(said.status, 2);
  EXPECT_NE(said.err.find("'o/results.json' can't be written: what is there is no regular file"),
            std::string::npos)
      << said.err;
  std::filesystem::remove(folder.path() / "o/results.json");
  std::filesystem::create_directory(folder.path() / "o/results.json");
  said = tandem(folder, {"run", two_mass_file("two_mass.toml"), "--output", "o"});
  EXPECT_EQ(said.status, 2);
  EXPECT_NE(said.err.find("'o/results.json' can't be written: there is a folder"), std::string::npos)
      << said.err;
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "o/results.csv"));
}

/// As on a full disk, a write stops in the middle: of a file that may have 100 kB.
TEST(RunCommand, WhatIsOnAFullDiskStaysReadable) {
  const Scratch folder;
  const std::string run = test::shell_quoted(TANDEM_COMMAND) + " run " +
                          test::shell_quoted(two_mass_file("two_mass.toml")) + " --no-reference --output ";
  ASSERT_EQ(
      tandem(folder, {"run", two_mass_file("two_mass.toml"), "--no-reference", "--output", "whole"}).status,
      0);
  const auto limited = [&](const std::string& blocks, const std::string& output) {
    const auto line = "cd " + test::shell_quoted(folder.path().string()) + " && ulimit -f " + blocks +
                      " && " + run + output + " 2>err.txt";
    return std::system(line.c_str());
  };
  EXPECT_NE(limited("1", "little"), 0);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "little/results.json")) << "half a text";
  EXPECT_NE(limited("200", "o"), 0);
  const std::string err = read_text(folder.path() / "err.txt"),
                    rows = read_text(folder.path() / "o/results.csv");
  EXPECT_NE(err.find("'o/results.csv' can't be written: File too large"), std::string::npos) << err;
  EXPECT_GT(rows.size(), 50000U);
  EXPECT_EQ(rows.back(), '\n');
  EXPECT_EQ(read_text(folder.path() / "whole/results.csv").substr(0, rows.size()), rows);
}

TEST(RunCommand, BinaryResultsHoldTheSameNumbersInTheirPlace) {
  const Scratch folder;
  const std::vector<std::string> run = {"run", two_mass_file("two_mass.toml"), "--no-reference", "--output"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), run.begin(), run.end());
    return tandem(folder, more).status;
  };
  ASSERT_EQ(with({"text"}), 0);
  ASSERT_EQ(with({"o"}), 0);
  ASSERT_EQ(with({"o", "--set", "record.format=npy"}), 0);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "o/results.csv"));
  EXPECT_EQ(tandem(folder, {"compare", "o", "text"}).status, 0);
  EXPECT_EQ(tandem(folder, {"compare", "text", "o/results.npy"}).status, 0);
  ASSERT_EQ(with({"o"}), 0);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "o/results.npy"));
}

/// Of a file that may have 100 kB; numpy takes what its head says there is.
TEST(RunCommand, BinaryRowsOnAFullDiskStayReadable) {
  const Scratch folder;
  const auto line = "cd " + test::shell_quoted(folder.path().string()) + " && ulimit -f 200 && " +
                    test::shell_quoted(TANDEM_COMMAND) + " run " +
                    test::shell_quoted(two_mass_file("two_mass.toml")) +
                    " --no-reference --set record.format=npy --output o 2>err.txt";
  EXPECT_NE(std::system(line.c_str()), 0);
  const auto rows = text::TimeTable::read(folder.path() / "o/results.npy");
  EXPECT_GT(rows.times.size() * (rows.names.size() + 1) * 8, 90000U);
  ASSERT_EQ(
      tandem(folder, {"run", two_mass_file("two_mass.toml"), "--no-reference", "--output", "whole"}).status,
      0);
  auto whole = text::TimeTable::read(folder.path() / "whole");
  whole.times.resize(rows.times.size());
  EXPECT_EQ(whole.times, rows.times);
}

/// A row takes 100 000 steps of the fast side, so they are there long before any buffer is full.
TEST(RunCommand, WhatIsRecordedIsThereSoonAndStaysWhenTheProcessIsKilled) {
  const Scratch folder;
  const auto file = folder.path() / "o/results.csv";
  test::Background run(folder, {"run", two_mass_file("two_mass.toml"), "--no-reference", "--output", "o",
                                "--set", "span.stop=1e12", "--set", "parameters.frequency_ratio=1e5", "--set",
                                "connections.reconstruction=lagrange0", "--set", "record.clock=slow", "--set",
                                "record.ports=[\"slow.x2\"]"});
  ASSERT_TRUE(run.wait_for_file(file)) << run.err();
  EXPECT_EQ(run.end_by(SIGKILL), -1);
  const std::string rows = read_text(file);
  EXPECT_EQ(rows.back(), '\n');
  EXPECT_LT(rows.size(), std::size_t{1} << 18) << "the size of the buffer";
  EXPECT_GT(TimeTable::read(folder.path() / "o").times.size(), 1U);
}

}  // namespace
}  // namespace tandem
