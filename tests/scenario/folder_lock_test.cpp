// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Two commands that would write to one folder at a time.
#include <gtest/gtest.h>

#include <map>

#include "background.hpp"

namespace tandem::test {
namespace {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;

/// Long enough to be met in the middle.
Arguments long_run_to(const std::string& output) {
  return {"run",
          two_mass_file("two_mass.toml"),
          "--no-reference",
          "--quiet",
          "--set",
          "span.stop=20000",
          "--output",
          output};
}

/// The files below a folder, with what is in them.
std::map<std::string, std::string> contents_of(const fs::path& folder) {
  std::map<std::string, std::string> all;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    all[entry.path().string()] = entry.is_directory() ? "" : read_text(entry.path());
  return all;
}

Arguments with(Arguments words, const Arguments& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// A run in the middle of its way, in "cut": it stands still while others try.
class TwoInAFolder : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(first.wait_for_file(folder.path() / "cut/checkpoint")) << first.err();
    kill(first.process(), SIGSTOP);
  }
  /// What the second is told, while the first goes on.
  void refused(const Arguments& second) {
    const Said said = tandem(folder, second);
    EXPECT_EQ(said.status, 2) << second[0];
    EXPECT_TRUE(contains(said.err, "tandem: folder 'cut' is being written by another tandem")) << said.err;
#ifdef __linux__
    EXPECT_TRUE(contains(said.err, "(process " + std::to_string(first.process()) + ")")) << said.err;
#endif
  }

  const Scratch folder;
  Background first{folder, with(long_run_to("cut"), {"--checkpoint-every", "100"})};
};

TEST_F(TwoInAFolder, TheSecondIsRefusedAndTheFirstEndsAsIfAlone) {
  refused(long_run_to("cut"));
  refused(with(long_run_to("cut"), {"--resume", "cut/checkpoint"}));
  refused({"sweep", two_mass_file("study.toml"), "--output", "cut"});
  refused({"ladder", TANDEM_SOURCE_DIR "/scenarios/kart/kart.toml", "--output", "cut"});
  refused({"bench", "exchange", "--output", "cut"});
  EXPECT_EQ(tandem(folder, with(long_run_to("cut"), {"--dry-run"})).status, 0);
  kill(first.process(), SIGCONT);
  EXPECT_EQ(first.end(), 0) << first.err();
  ASSERT_EQ(tandem(folder, long_run_to("whole")).status, 0);
  for (const char* name : {"results.csv", "results.json"})
    EXPECT_EQ(read_text(folder.path() / "cut" / name), read_text(folder.path() / "whole" / name)) << name;
  fs::remove(folder.path() / "cut/checkpoint");
  EXPECT_EQ(contents_of(folder.path() / "cut").size(), contents_of(folder.path() / "whole").size())
      << "no file of the lock stays";
}

TEST_F(TwoInAFolder, OneThatWasKilledHoldsNothing) {
  EXPECT_EQ(first.end_by(SIGKILL), -1);
  const Said said = tandem(folder, with(long_run_to("cut"), {"--resume", "cut/checkpoint"}));
  EXPECT_EQ(said.status, 0) << said.err;
}

TEST(FolderLockCommand, ARunThatIsRefusedChangesNothingInTheFolder) {
  const Scratch folder;
  ASSERT_EQ(tandem(folder, {"run", two_mass_file("two_mass.toml"), "--no-reference", "--output", "o"}).status,
            0);
  Background sweep(folder, {"sweep", two_mass_file("study.toml"), "--output", "o"});
  ASSERT_TRUE(sweep.wait_for_file(folder.path() / "o/sweep.part")) << sweep.err();
  kill(sweep.process(), SIGSTOP);
  const auto before = contents_of(folder.path() / "o");
  const Said said = tandem(folder, long_run_to("o"));
  EXPECT_EQ(said.status, 2);
  EXPECT_EQ(contents_of(folder.path() / "o"), before);
  EXPECT_TRUE(contains(said.err, "folder 'o' is being written by another tandem")) << said.err;
}

TEST(FolderLockCommand, ARunThatCanNotBeginLeavesNoFolder) {
  const Scratch folder;
  const Said said = tandem(folder, {"run", two_mass_file("two_mass.toml"), "--set",
                                    "subsystems.slow.source=unix:/none", "--output", "a/b"});
  EXPECT_EQ(said.status, 2);
  EXPECT_FALSE(fs::exists(folder.path() / "a"));
}

TEST(FolderLockCommand, ALogIsWrittenByOneAtATime) {
  const Scratch folder;
  Arguments words = long_run_to("o");
  std::erase(words, "--quiet");
  Background first(folder, with({"--verbose", "--log", "log"}, words));
  ASSERT_TRUE(first.wait_for_file(folder.path() / "log")) << first.err();
  kill(first.process(), SIGSTOP);
  const Said said = tandem(folder, with({"--log", "log"}, long_run_to("p")));
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said.err, "tandem: log file 'log' is being written by another tandem")) << said.err;
  EXPECT_FALSE(fs::exists(folder.path() / "p"));
  EXPECT_GT(fs::file_size(folder.path() / "log"), 0U) << "it is not begun anew";
}

TEST(FolderLockCommand, ALogTakesThePlaceOfALogOnly) {
  const Scratch folder;
  folder.write("results.csv", "time,x\n0,1\n");
  const Said said = tandem(folder, with({"--log", "results.csv"}, {"list"}));
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said.err, "log file 'results.csv' is there and is no log")) << said.err;
  EXPECT_EQ(read_text(folder.path() / "results.csv"), "time,x\n0,1\n");
  folder.write("empty", "");
  for (const char* again : {"log", "log", "empty"})
    EXPECT_EQ(tandem(folder, with({"--log", again, "--verbose"}, {"list"})).status, 0) << again;
}

/// Else what it writes to them would be in the first file that it opens.
TEST(FolderLockCommand, ARunWithoutStandardStreamsWritesItsResults) {
  const Scratch folder;
  const std::string scene = TANDEM_SOURCE_DIR "/scenarios/two_mass/two_mass.toml";
  const std::string command =
      "cd '" + folder.path().string() + "' && '" TANDEM_COMMAND "' run '" + scene + "' --output ";
  ASSERT_EQ(std::system((command + "a 2>/dev/null >/dev/null").c_str()), 0);
  ASSERT_EQ(std::system((command + "b <&- >&- 2>&-").c_str()), 0);
  for (const char* file : {"/results.csv", "/results.json"})
    EXPECT_EQ(read_text(folder.path().string() + "/a" + file).size(),
              read_text(folder.path().string() + "/b" + file).size())
        << file;
}

/// What it was killed in the middle of writing.
TEST(FolderLockCommand, TheNextRunTakesThePartOfACheckpointAway) {
  const Scratch folder;
  fs::create_directory(folder.path() / "o");
  folder.write("o/checkpoint.part", "half");
  const Arguments run = {"run", two_mass_file("two_mass.toml"), "--no-reference", "--output", "o"};
  EXPECT_EQ(tandem(folder, with(run, {"--dry-run"})).status, 0);
  EXPECT_TRUE(fs::exists(folder.path() / "o/checkpoint.part"));
  EXPECT_EQ(tandem(folder, run).status, 0);
  EXPECT_FALSE(fs::exists(folder.path() / "o/checkpoint.part"));
}

}  // namespace
}  // namespace tandem::test
