// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What would lie beside results, or pass unseen in a file, is told.
#include <gtest/gtest.h>

#include <cmath>

#include "command.hpp"
#include "json_of.hpp"
#include "tandem/text/time_table.hpp"

namespace tandem::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> run_of(const std::string& output, const std::vector<std::string>& sets = {}) {
  std::vector<std::string> words = {
      "run", two_mass_file("two_mass.toml"), "--no-reference", "--output", output, "--set", "span.stop=1"};
  for (const std::string& one : sets) words.insert(words.end(), {"--set", one});
  return words;
}

TEST(HonestResults, AChartTellsARunThatDidNotEnd) {
  const Scratch folder;
  EXPECT_EQ(tandem(folder, run_of("o", {"span.diverged_beyond=1.0001"})).status, 1);
  const Said said = tandem(folder, {"chart", "o", "--plot", "fast.x1"});
  EXPECT_EQ(said.status, 0) << said.err;
  const std::string sentence = "is of a run that did not come to its end: diverged";
  EXPECT_TRUE(contains(said.err, sentence)) << said.err;
  EXPECT_TRUE(contains(read_text(folder.path() / "o/plot.gp"), sentence));
}

TEST(HonestResults, RowsOfAnotherClockOrFormatGo) {
  const Scratch folder;
  ASSERT_EQ(tandem(folder, run_of("o", {"record.clock=own", "record.format=npy"})).status, 0);
  ASSERT_TRUE(fs::exists(folder.path() / "o/results.fast.npy"));
  folder.write("o/results.of_mine.csv", "");
  const auto old = folder.path() / "o/results.slow.npy";
  ASSERT_EQ(tandem(folder, run_of("o", {"reference.file=" + old.string()})).status, 0);
  EXPECT_TRUE(fs::exists(folder.path() / "o/results.csv"));
  EXPECT_FALSE(fs::exists(folder.path() / "o/results.fast.npy"));
  EXPECT_TRUE(fs::exists(folder.path() / "o/results.of_mine.csv"));
  EXPECT_TRUE(fs::exists(old));  // a reference
}

TEST(HonestResults, ARunDoesNotWriteOverItsReference) {
  const Scratch folder;
  ASSERT_EQ(tandem(folder, run_of("o")).status, 0);
  const std::string before = read_text(folder.path() / "o/results.csv");
  for (const char* reference : {"o/results.csv", "o"}) {
    const Said said = tandem(folder, {"run", two_mass_file("two_mass.toml"), "--output", "o", "--set",
                                      "reference.file=" + (folder.path() / reference).string()});
    EXPECT_EQ(said.status, 2);
    EXPECT_TRUE(contains(said.err, "which this run writes")) << said.err;
  }
  EXPECT_EQ(read_text(folder.path() / "o/results.csv"), before);
}

TEST(HonestResults, ADamagedStatusIsNoGoodOne) {
  const Scratch folder;
  ASSERT_EQ(tandem(folder, run_of("r")).status, 0);
  const std::string json = read_text(folder.path() / "r/results.json");
  folder.write("r/results.json", json.substr(0, json.size() / 2));
  const std::vector<std::string> against = {
      "--set", "reference.file=" + (folder.path() / "r/results.csv").string(), "--set", "span.stop=1"};
  for (const char* command : {"run", "validate"}) {
    std::vector<std::string> words = {command, two_mass_file("two_mass.toml")};
    words.insert(words.end(), against.begin(), against.end());
    const Said said = tandem(folder, words);
    EXPECT_EQ(said.status, 2) << command;
    EXPECT_TRUE(contains(said.err, "a results.json that is damaged")) << said.err;
  }
}

/// Multiples of a period far below rounding could not be counted.
TEST(HonestResults, PeriodsAndWindowsThatAreNoneAreRefused) {
  const Scratch folder;
  for (const auto& [set, word] : {std::pair{"record.every=1e-20", "allowed is a number from 1e-15 s"},
                                  {"judge.from=5", "before span.stop"},
                                  {"judge.to=-1", "after span.start"},
                                  {"judge.shift=2", "below the span's length"}}) {
    const Said said = tandem(folder, run_of("o", {"judge.quantity=fast.x1", "judge.tolerance=1", set}));
    EXPECT_EQ(said.status, 2) << set;
    EXPECT_TRUE(contains(said.err, word)) << said.err;
  }
  EXPECT_EQ(tandem(folder, run_of("o", {"record.every=1e-14"})).status, 0);
  const Said empty = tandem(folder, run_of("o", {"record.from=1e-7", "record.to=2e-7"}));
  EXPECT_EQ(empty.status, 0);
  EXPECT_TRUE(contains(empty.err, "note: file 'o/results.csv' has no rows")) << empty.err;
}

TEST(HonestResults, AMeasureBesideNoSpanIsNotLookedAt) {
  const Scratch folder;
  folder.write("s.toml",
               "[subsystems.a]\nsource = 'builtin:two_mass.both'\n[judge]\nquantity = 'a.x1'\ntolerance = "
               "1\nshift = 1\n");
  const Said said = tandem(folder, {"validate", "s.toml"});
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said.err, "span is missing")) << said.err;
}

/// One that a run has written tells how it ended, by whatever name it is called.
TEST(HonestResults, AResultsJsonThatIsNotOfARunIsNoGoodOne) {
  const Scratch folder;
  ASSERT_EQ(tandem(folder, run_of("r")).status, 0);
  auto about = json_of(folder.path() / "r/results.json");
  for (const auto& [missing, why] : {std::pair{"status", "come to its end: it tells no status"},
                                     {"files", "is not one of a run: files is missing"}}) {
    about.erase(missing);
    folder.write("r/results.json", about.dump());
    const Said said =
        tandem(folder, {"validate", two_mass_file("two_mass.toml"), "--set",
                        "reference.file=" + (folder.path() / "r").string(), "--set", "span.stop=1"});
    EXPECT_EQ(said.status, 2) << missing;
    EXPECT_TRUE(contains(said.err, why)) << said.err;
  }
}

TEST(HonestResults, PagesAndPicturesOfEarlierOnesGo) {
  const Scratch folder;
  fs::create_directory(folder.path() / "o");
  folder.write("o/view.html", "mine");
  ASSERT_EQ(tandem(folder, run_of("o")).status, 0);
  EXPECT_EQ(read_text(folder.path() / "o/view.html"), "mine") << "there were no results";
  ASSERT_EQ(tandem(folder, {"view", "o"}).status, 0);
  for (const char* name : {"plot.svg", "plot.csv", "of_mine.svg"}) folder.write(std::string("o/") + name, "");
  ASSERT_EQ(tandem(folder, run_of("o")).status, 0);
  for (const char* name : {"view.html", "plot.svg"})
    EXPECT_FALSE(fs::exists(folder.path() / "o" / name)) << name;
  for (const char* name : {"plot.csv", "of_mine.svg"})  // these may be data
    EXPECT_TRUE(fs::exists(folder.path() / "o" / name)) << name;
}

/// Before the run, not after hours of it.
TEST(HonestResults, WindowsThatLeaveNothingToCompareAreRefused) {
  const Scratch folder;
  ASSERT_EQ(tandem(folder, run_of("r")).status, 0);
  const std::string file = "reference.file=" + (folder.path() / "r").string();
  folder.write("one.csv", "time,fast.x1\n5,1\n");
  const std::string one = "reference={file='" + (folder.path() / "one.csv").string() + "',tolerance=1";
  for (const std::string& window :
       std::vector<std::string>{"record.from=1.5", "reference.from=1.2", "reference.to=-0.5", one + "}",
                                one + ",from=5.3,shift=0.5}"}) {
    const Said said = tandem(folder, {"run", two_mass_file("two_mass.toml"), "--output", "o", "--set", file,
                                      "--set", "span.stop=2", "--set", window});
    EXPECT_EQ(said.status, 2) << window;
    EXPECT_FALSE(fs::exists(folder.path() / "o/results.csv"));
  }
}

/// All of them, whoever's words they are.
TEST(HonestResults, EachLineOfMessagesBeginsWithTheProgram) {
  const Scratch folder;
  ASSERT_EQ(tandem(folder, run_of("o")).status, 0);
  ASSERT_EQ(tandem(folder, run_of("bad", {"span.diverged_beyond=1.0001"})).status, 1);
  for (const std::vector<std::string>& words :
       {run_of("o"),
        {"run", "no\nsuch.toml"},
        {"compare", "bad", "bad"},
        {"view", "bad"},
        {"help", "a\nb"},
        {"sweep", two_mass_file("two_mass.toml"), "--set", "span.stop=1", "--output", "t"}}) {
    std::istringstream lines(tandem(folder, words).err);
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count)
      EXPECT_TRUE(line.starts_with("tandem: ")) << line;
    EXPECT_GT(count, 0) << words[0];
  }
}

/// On a full disk: bad luck, no bad input.
TEST(HonestResults, AFullDiskIsStatusOneEverywhere) {
  const Scratch folder;
  ASSERT_EQ(tandem(folder, run_of("o", {"span.stop=20"})).status, 0);
  const Said view = tandem(folder, {"-c", "ulimit -f 2; exec " TANDEM_COMMAND " view o"}, "bash");
  EXPECT_EQ(view.status, 1) << view.err;
  EXPECT_TRUE(contains(view.err, "view.html' can't be written: File too large")) << view.err;
  EXPECT_FALSE(contains(view.err, ".part")) << view.err;
  const Said run =
      tandem(folder,
             {"-c", "(ulimit -f 0; exec '" TANDEM_COMMAND "' run '" + two_mass_file("two_mass.toml") +
                        "' --output n) 2>&1 | cat; exit ${PIPESTATUS[0]}"},
             "bash");
  EXPECT_EQ(run.status, 1) << run.out;
  EXPECT_TRUE(contains(run.out, "'n/results.json' can't be written: File too large")) << run.out;
}

TEST(HonestResults, FewerThreadsThanWantedDoTheSame) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer needs more addresses";
#endif
  const Scratch folder;
  folder.write("study.toml",
               "scenario = '" + two_mass_file("two_mass.toml") +
                   "'\ncolumns = ['stop']\n[set]\n'span.stop' = '$(stop)'\n"
                   "[[tables.t.blocks]]\naxes = [{ stop = [0.1, 0.2, 0.3] }]\n[metrics]\nexchanges = {}\n");
  ASSERT_EQ(tandem(folder, {"sweep", "study.toml", "--threads", "1", "--output", "one"}).status, 0);
  const Said said =
      tandem(folder,
             {"-c", "ulimit -v 400000; exec " TANDEM_COMMAND " sweep study.toml --threads 256 --output many"},
             "bash");
  if (said.status == 1)
    EXPECT_TRUE(contains(said.err, "tandem: ")) << said.err;  // no memory for one of them
  else
    EXPECT_EQ(read_text(folder.path() / "many/t.csv"), read_text(folder.path() / "one/t.csv")) << said.err;
  EXPECT_GE(said.status, 0);
}

TEST(HonestResults, ASettingThatAStudyMakesAgainIsRefused) {
  const Scratch folder;
  folder.write("study.toml",
               "scenario = '" + two_mass_file("two_mass.toml") +
                   "'\ncolumns = ['stop']\n[set]\n'span.stop' = '$(stop)'\n'connections[0].gain' = '$(1)'\n"
                   "[[tables.t.blocks]]\naxes = [{ stop = [0.1] }]\n[metrics]\nexchanges = {}\n");
  for (const auto& [set, where] :
       {std::pair{"span.stop=9", "study.toml:4: the study sets span.stop itself"},
        {"span={start=0,stop=9}", "study.toml:4: the study sets span.stop itself"},
        {"connections[fast.x2].gain=2", "study.toml:5: the study sets connections"}}) {
    const Said said = tandem(folder, {"sweep", "study.toml", "--set", set});
    EXPECT_EQ(said.status, 2) << set;
    EXPECT_TRUE(contains(said.err, where)) << said.err;
  }
  for (const std::string set : {"span.start=-0.1", "connections[1].gain=1"})
    EXPECT_EQ(tandem(folder, {"sweep", "study.toml", "--set", set}).status, 0) << set;
}

TEST(HonestResults, OptionsAreToldLikeEverythingElse) {
  const Scratch folder;
  for (const auto& words : std::vector<std::vector<std::string>>{{},
                                                                 {"help"},
                                                                 {"schema", "foo"},
                                                                 {"run"},
                                                                 {"run", "x", "--bogus"},
                                                                 {"run", "x", "--threads", "0"},
                                                                 {"compare", "x", "y", "--norm", "z"},
                                                                 {"compare", "x", "y", "--from", "z"},
                                                                 {"ladder", "x", "--repetitions", "z"},
                                                                 {"export", "x", "y.fmu", "--fmi", "4"},
                                                                 {"view", "x", "--every", "0"},
                                                                 {"sweep", "x", "--seed", "-1"},
                                                                 {"check", "x", "--start", "nan"},
                                                                 {"serve", "x", "--idle", "inf"}}) {
    const Said said = tandem(folder, words);
    EXPECT_EQ(said.status, 2) << said.err;
    EXPECT_TRUE(said.err.starts_with("tandem: ")) << said.err;
    EXPECT_EQ(std::count(said.err.begin(), said.err.end(), '\n'), 1) << said.err;
    EXPECT_LT(said.err.size(), 200U) << said.err;
  }
}

TEST(HonestResults, WhatNoClientCanMendIsNotServed) {
  const Scratch folder;
  folder.write(
      "m.toml",
      "dimension = 2\n[coordinates]\nx = { unit = 'm', inertia = 1 }\n[outputs]\nx = { position = 'x' }\n");
  for (const char* source : {"builtin:two_mass.slow?foo=1", "diagram:m.toml", "mechanism:m.toml?step=abc"})
    EXPECT_EQ(tandem(folder, {"serve", source, "--listen", "unix:s"}).status, 2) << source;
}

}  // namespace
}  // namespace tandem::test
