// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// tandem run --checkpoint-every and --resume.
#include <gtest/gtest.h>

#include "background.hpp"
#include "command.hpp"

namespace tandem {
namespace {

using test::Background;
using test::contains;
using test::read_text;
using test::Said;
using test::Scratch;
using test::tandem;
using test::two_mass_file;
using Arguments = std::vector<std::string>;

Arguments joined(Arguments words, const Arguments& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::string scene(const std::string& file) { return TANDEM_SOURCE_DIR "/scenarios/" + file; }

/// The whole run in the folder `whole`; the same with checkpoints in `cut`, then again from the last of them.
void goes_on(const Arguments& what, const std::string& every, const char* rows = "results.csv") {
  const Scratch folder;
  const Arguments run = joined({"run"}, joined(what, {"--no-reference", "--output"}));
  Said said = tandem(folder, joined(run, {"whole"}));
  ASSERT_EQ(said.status, 0) << said.err;
  said = tandem(folder, joined(run, {"cut", "--checkpoint-every", every}));
  ASSERT_EQ(said.status, 0) << said.err;
  const auto whole = folder.path() / "whole", cut = folder.path() / "cut";
  EXPECT_EQ(read_text(cut / rows), read_text(whole / rows));
  said = tandem(folder, joined(run, {"cut", "--resume", "cut/checkpoint"}));
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_TRUE(contains(said.out, "resumed at t = ")) << said.out;
  for (const char* name : {rows, "results.json"})
    EXPECT_EQ(read_text(cut / name), read_text(whole / name)) << what[0] << ", " << name;
}

TEST(CheckpointCommand, ScenesGoOnToTheSameFiles) {
  goes_on({two_mass_file("two_mass.toml")}, "30");
  goes_on({two_mass_file("impulse.toml")}, "100");
  goes_on({two_mass_file("impulse.toml"), "--set", "parameters.frequency_ratio=60", "--set", "span.stop=60"},
          "25");
  goes_on({scene("pushed_pendulum/pushed_pendulum.toml")}, "40");
  goes_on({scene("engine_linkage/engine_linkage.toml"), "--set", "span.stop=0.5"}, "0.13");
  goes_on({scene("split_pendulum/split_pendulum.toml"), "--set", "span.stop=0.5"}, "0.13");
}

TEST(CheckpointCommand, BinaryResultsGoOnToTheSameFiles) {
  const Arguments binary = {two_mass_file("two_mass.toml"), "--set", "record.format=npy"};
  goes_on(binary, "30", "results.npy");
  goes_on(joined(binary, {"--set", "record.clock=own"}), "30", "results.fast.npy");
}

TEST(CheckpointCommand, AMechanismAloneGoesOnToTheSameFiles) {
  goes_on({scene("mechanisms/bricard/bricard.toml"), "--set", "run.stop=2.5", "--set", "run.step=1e-3"}, "1");
}

TEST(CheckpointCommand, GoesOnWithASubsystemInAnotherProcess) {
  goes_on({two_mass_file("two_mass.toml"), "--set", "span.stop=20", "--set",
           "subsystems.slow.source=spawn:" TANDEM_COMMAND " serve builtin:two_mass.slow"},
          "7");
}

/// Long enough to be caught in the middle.
const Arguments long_run = {"run", two_mass_file("two_mass.toml"), "--no-reference", "--set",
                            "span.stop=20000"};

class CheckpointAfter : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Signals, CheckpointAfter, testing::Values(SIGINT, SIGTERM, SIGKILL),
                         [](const auto& p) { return "signal" + std::to_string(p.param); });

TEST_P(CheckpointAfter, ARunThatIsEndedBySignalGoesOnToTheSameFiles) {
  const Scratch folder;
  ASSERT_EQ(tandem(folder, joined(long_run, {"--output", "whole"})).status, 0);
  const std::string every = GetParam() == SIGKILL ? "10" : "1e9";
  Background run(folder, joined(long_run, {"--output", "cut", "--checkpoint-every", every, "--quiet"}));
  ASSERT_TRUE(
      run.wait_for_file(folder.path() / (GetParam() == SIGKILL ? "cut/checkpoint" : "cut/results.csv")));
  EXPECT_EQ(run.end_by(GetParam()), GetParam() == SIGKILL ? -1 : 1);
  if (GetParam() != SIGKILL) {
    EXPECT_TRUE(contains(run.err(), "interrupted at t = ") &&
                contains(run.err(), "--resume cut/checkpoint goes on from there"))
        << run.err();
  }
  const Said said = tandem(folder, joined(long_run, {"--output", "cut", "--resume", "cut/checkpoint"}));
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_EQ(read_text(folder.path() / "cut/results.csv"), read_text(folder.path() / "whole/results.csv"));
}

/// A short run's checkpoint, to be spoilt.
class CheckpointFile : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(tandem(folder, joined(run, {"--checkpoint-every", "1"})).status, 0);
    whole = read_text(file());
  }
  std::filesystem::path file() const { return folder.path() / "o/checkpoint"; }
  /// What it says of the file with these bytes, with more words of the command.
  Said resumed(const std::string& bytes, const Arguments& more = {}) const {
    folder.write("o/checkpoint", bytes);
    const std::string before = read_text(folder.path() / "o/results.csv");
    const Said said = tandem(folder, joined(joined(run, {"--resume", "o/checkpoint"}), more));
    EXPECT_EQ(read_text(folder.path() / "o/results.csv"), before);
    return said;
  }
  const Arguments run = {
      "run", two_mass_file("two_mass.toml"), "--no-reference", "--set", "span.stop=3", "--output", "o"};
  Scratch folder;
  std::string whole;
};

TEST_F(CheckpointFile, IsRefusedWithTheReason) {
  std::string damaged = whole, of_another_version = whole;
  damaged[damaged.size() - 100] ^= 1;
  of_another_version[8] = 77;
  const std::pair<std::string, std::string> cases[] = {
      {damaged, "is damaged"},
      {whole.substr(0, whole.size() / 2), "is truncated"},
      {whole.substr(0, 20), "is truncated"},
      {whole + "x", "has grown"},
      {of_another_version, "has the format version 77; allowed is 9"},
      {"time,fast.x1\n", "is no checkpoint"},
      {"", "is no checkpoint"}};
  for (const auto& [bytes, reason] : cases) {
    const Said said = resumed(bytes);
    EXPECT_EQ(said.status, 2);
    EXPECT_TRUE(contains(said.err, "checkpoint 'o/checkpoint' " + reason)) << said.err;
  }
}

TEST_F(CheckpointFile, OfAnotherRunIsRefusedWithTheFirstDifference) {
  Said said = resumed(whole, {"--set", "parameters.frequency_ratio=12"});
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(
      contains(said.err, "is of another run: scenario/parameters/frequency_ratio is 25.0 there; allowed is"))
      << said.err;
}

TEST_F(CheckpointFile, GoesOnAtAnotherAddress) {
  const std::string before = read_text(folder.path() / "o/results.csv");
  const auto at = [](const std::string& command, const std::string& parameters = "") -> Arguments {
    return {"--set", "subsystems.slow.source=spawn:" + command +
                         TANDEM_COMMAND " serve builtin:two_mass.slow" + parameters};
  };
  ASSERT_EQ(tandem(folder, joined(joined(run, {"--checkpoint-every", "1"}), at(""))).status, 0);
  Said said = tandem(folder, joined(joined(run, {"--resume", "o/checkpoint"}), at("env ")));
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_EQ(read_text(folder.path() / "o/results.csv"), before);
  said = tandem(folder, joined(joined(run, {"--resume", "o/checkpoint"}), at("", "?spin=0")));
  EXPECT_TRUE(contains(said.err, "slow/source is \"elsewhere\" there")) << said.err;
}

TEST_F(CheckpointFile, WithOtherResultsIsRefused) {
  folder.write("o/results.csv", "time,fast.x1\n0,1\n");
  Said said = resumed(whole);
  EXPECT_TRUE(contains(said.err, "results.csv' can't be gone on with: it is shorter than")) << said.err;
  folder.write("o/results.csv", std::string(1 << 20, '\n'));
  said = resumed(whole);
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said.err, "bytes are others than those of the run at the checkpoint")) << said.err;
}

TEST(CheckpointCommand, ResultsWithAnEarlyRowChangedAreRefusedAndLeftAsTheyAre) {
  const Scratch folder;
  const Arguments run = {"run", two_mass_file("two_mass.toml"), "--no-reference", "--output", "o"};
  ASSERT_EQ(tandem(folder, joined(run, {"--checkpoint-every", "1"})).status, 0);
  std::string rows = read_text(folder.path() / "o/results.csv");
  ASSERT_GT(rows.size(), 1U << 18) << "more than one block of what is read";
  rows[rows.find('\n') + 1] = '7';
  folder.write("o/results.csv", rows);
  const Said said = tandem(folder, joined(run, {"--resume", "o/checkpoint"}));
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said.err, "o/results.csv' can't be gone on with: its first ")) << said.err;
  EXPECT_EQ(read_text(folder.path() / "o/results.csv"), rows);
}

TEST_F(CheckpointFile, ThatIsNotThereIsRefused) {
  const Said said = tandem(folder, joined(run, {"--resume", "nowhere"}));
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said.err, "checkpoint 'nowhere' is not there")) << said.err;
}

TEST(CheckpointCommand, ASubsystemThatCanNotIsNamedBeforeTheRun) {
  const Scratch folder;
  const Said said =
      tandem(folder, {"run", scene("engine_linkage/engine_linkage.toml"), "--set",
                      "subsystems.engine.parameters.integrator=cvode_bdf", "--checkpoint-every", "1"});
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said.err, "engine_linkage.toml:") && contains(said.err, "subsystem 'engine'") &&
              contains(said.err, "checkpoint"))
      << said.err;
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "results"));
  EXPECT_EQ(tandem(folder, {"run", two_mass_file("two_mass.toml"), "--checkpoint-every", "0"}).status, 2);
}

TEST(CheckpointCommand, AFullDiskEndsTheRunWithASentence) {
  const Scratch folder;
  // A checkpoint has more than the 4 kB that a file may have here, the first rows have less.
  const std::string line = "cd " + test::shell_quoted(folder.path().string()) + " && ulimit -f 8 && " +
                           test::shell_quoted(TANDEM_COMMAND) + " run " +
                           test::shell_quoted(two_mass_file("two_mass.toml")) +
                           " --no-reference --output o --checkpoint-every 0.01 2>err.txt";
  EXPECT_EQ(WEXITSTATUS(std::system(line.c_str())), 1);
  const std::string err = read_text(folder.path() / "err.txt");
  EXPECT_TRUE(contains(err, "file 'o/checkpoint' can't be written: File too large")) << err;
  for (const char* name : {"o/checkpoint", "o/checkpoint.part"})
    EXPECT_FALSE(std::filesystem::exists(folder.path() / name)) << name;
}

TEST(CheckpointCommand, ThatNoneWasWrittenIsTold) {
  const Scratch folder;
  const Said said = tandem(folder, {"run", two_mass_file("two_mass.toml"), "--no-reference", "--set",
                                    "span.stop=3", "--output", "o", "--checkpoint-every", "5"});
  EXPECT_EQ(said.status, 0);
  EXPECT_TRUE(contains(said.err, "note: no checkpoint was written")) << said.err;
}

TEST(CheckpointCommand, ThatNoneWasWrittenIsToldBesideAnEarlierOne) {
  const Scratch folder;
  const auto run = [&](const std::string& every) {
    return tandem(folder, {"run", two_mass_file("two_mass.toml"), "--no-reference", "--set", "span.stop=3",
                           "--output", "o", "--checkpoint-every", every});
  };
  EXPECT_FALSE(contains(run("1").err, "checkpoint"));
  const Said said = run("5");
  EXPECT_TRUE(contains(said.err, "note: no checkpoint was written")) << said.err;
  EXPECT_TRUE(contains(said.err, "o/checkpoint is an earlier run's")) << said.err;
}

}  // namespace
}  // namespace tandem
