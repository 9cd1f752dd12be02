// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// command = ["prog", "arg"] in place of a source: a program without a shell.
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "command.hpp"

namespace tandem::test {
namespace {

namespace fs = std::filesystem;

std::string toml_text(const std::string& text) {
  std::string all = "\"";
  for (const char c : text) all += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
  return all + "\"";
}

/// The two masses, the slow one by these lines.
std::string two_masses(const std::string& slow) {
  std::string text = read_text(two_mass_file("two_mass.toml"));
  const std::string from = "source = \"builtin:two_mass.slow\"";
  text.replace(text.find(from), from.size(), slow);
  return text.substr(0, text.find("[reference]")) + text.substr(text.find("[judge]"));
}

const std::string serving = "[" + toml_text(TANDEM_COMMAND) + ", \"serve\", \"builtin:two_mass.slow\"]",
                  served = "command = " + serving;

class CommandSource : public testing::Test {
 protected:
  Said run(const std::string& slow, std::vector<std::string> more = {}) {
    folder_.write("s.toml", two_masses(slow));
    std::vector<std::string> all{"--quiet", "run", "s.toml", "--set", "span.stop=1", "--output", "o"};
    all.insert(all.end(), more.begin(), more.end());
    return tandem(folder_, all);
  }
  std::string rows() const { return read_text(folder_.path() / "o/results.csv"); }
  void refused(const std::string& slow, const std::string& words) {
    const Said said = run(slow);
    EXPECT_EQ(said.status, 2) << slow;
    EXPECT_TRUE(contains(said.err, words)) << said.err;
  }
  Scratch folder_;
};

TEST_F(CommandSource, GivesTheSameBitsAsItsModelInTheProcess) {
  ASSERT_EQ(run("source = \"builtin:two_mass.slow\"").status, 0);
  const std::string builtin = rows();
  const Said said = run(served);
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_EQ(rows(), builtin);
  const auto json = nlohmann::json::parse(read_text(folder_.path() / "o/results.json"));
  const auto& slow = json["scenario"]["values"]["subsystems"]["slow"];
  EXPECT_EQ(slow["command"][1], "serve");
  EXPECT_FALSE(slow.contains("source"));
}

/// Each argument as it stands there, in the scenario's folder, by PATH.
TEST_F(CommandSource, TakesItsWordsAsTheyAre) {
  fs::create_directories(folder_.path() / "scene/bin");
  const std::vector<std::string> words = {"a b", "$HOME", "`id`", "; touch x", "'", "\"",
                                          "\\",  "*",     "",     "?x=1",      "ü"};
  std::string list = "\"say\"", expected;
  for (const std::string& word : words) list += ", " + toml_text(word), expected += word + "\n";
  fs::permissions(
      folder_.write("scene/bin/say", "#!/bin/sh\nprintf '%s\\n' \"$@\" > words\npwd -P > place\n"),
      fs::perms::owner_all);
  folder_.write("scene/s.toml", "[subsystems.s]\ncommand = [" + list + "]\n[span]\nstop = 1.0\n");
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", ("bin:" + path).c_str(), 1);
  const Said said = tandem(folder_, {"run", "scene/s.toml"});
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(said.status, 2);
  EXPECT_EQ(read_text(folder_.path() / "scene/words"), expected) << said.err;
  EXPECT_EQ(read_text(folder_.path() / "scene/place"),
            fs::canonical(folder_.path() / "scene").string() + "\n");
  EXPECT_TRUE(contains(said.err, "s.toml:2: subsystem 's': command [\"say\", \"a b\", ")) << said.err;
  EXPECT_TRUE(contains(said.err, "ended with status 0")) << said.err;
}

TEST_F(CommandSource, ItsStatusIsTold) {
  refused("command = [\"no_such_program\"]",
          "program [\"no_such_program\"] can't be started: No such file or directory");
  refused("command = [\"sh\", \"-c\", \"exit 3\"]", "ended with status 3");
  const Said fault = run("command = [\"sh\", \"-c\", \"kill -ABRT $$\"]");
  EXPECT_EQ(fault.status, 1) << "no bad input";
  EXPECT_TRUE(contains(fault.err, "was ended by signal 6")) << fault.err;
  folder_.write("text", "x");
  refused("command = [\"./text\"]", "program [\"./text\"] can't be started: Permission denied");
}

TEST_F(CommandSource, WhatIsNoneIsRefused) {
  refused(served + "\nsource = \"builtin:two_mass.slow\"", "subsystems.slow.command is given beside source");
  refused("command = []", "subsystems.slow.command is empty; allowed is an array of texts");
  refused("command = \"tandem serve\"",
          "subsystems.slow.command is the text 'tandem serve'; allowed is an array");
  refused("command = [\"tandem\", 3]", "subsystems.slow.command holds the number 3");
  refused("command = [[\"tandem\"]]", "subsystems.slow.command holds an array");
  refused("command = [\"\"]", "command [\"\"] names no program");
  refused("command = [\"true\", \"a\\u0000b\"]", "holds a character 0");
  refused("source = \"spawn:true\\u0000b\"", "holds a character 0");
  refused("comand = [\"true\"]",
          "subsystems.slow.source is missing; allowed is a source like \"builtin:NAME\", or command");
}

TEST_F(CommandSource, ItsOwnParametersAreItsOwnAndTheRestGoesToTheProgram) {
  refused("command = [\"sleep\", \"60\"]\nparameters = { deadline = 0.2 }", "deadline of 0.2 s");
  refused(served + "\nparameters = { no_such = 1 }", "'no_such' is not there");
  EXPECT_EQ(run(served + "\nparameters = { deadline = 20, spin = 0 }").status, 0);
}

TEST_F(CommandSource, TheCommandLineSetsItInPlaceOfASourceAndTheOtherWayRound) {
  ASSERT_EQ(run("source = \"builtin:two_mass.slow\"").status, 0);
  const std::string builtin = rows(), setting = "subsystems.slow.command=" + serving;
  EXPECT_EQ(run("source = \"builtin:two_mass.slow\"", {"--set", setting}).status, 0);
  EXPECT_EQ(rows(), builtin);
  EXPECT_EQ(run("command = [\"false\"]", {"--set", "subsystems.slow.source=builtin:two_mass.slow"}).status,
            0);
  EXPECT_EQ(rows(), builtin);
  EXPECT_EQ(run("command = [\"false\"]", {"--set", setting}).status, 0);
  EXPECT_EQ(run("command = [" + toml_text(TANDEM_COMMAND) + ", \"serve\", \"builtin:none\"]",
                {"--set", "subsystems.slow.command[2]=builtin:two_mass.slow"})
                .status,
            0);
  EXPECT_EQ(rows(), builtin);
}

/// Where a subsystem lives is no part of what a checkpoint is of.
TEST_F(CommandSource, ACheckpointGoesOnElsewhere) {
  ASSERT_EQ(run(served).status, 0);
  const std::string whole = rows();
  ASSERT_EQ(run(served, {"--checkpoint-every", "0.5"}).status, 0);
  for (const std::string& slow :
       {served, std::string("source = \"spawn:" TANDEM_COMMAND " serve builtin:two_mass.slow\"")}) {
    const Said said = run(slow, {"--resume", "o/checkpoint"});
    EXPECT_EQ(said.status, 0) << said.err;
    EXPECT_EQ(rows(), whole);
  }
  EXPECT_EQ(run("source = \"builtin:two_mass.slow\"", {"--resume", "o/checkpoint"}).status, 2);
}

}  // namespace
}  // namespace tandem::test
