// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// coordination.scheme = "auto", from the command line.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "command.hpp"
#include "tandem/advice/advice.hpp"
#include "tandem/charts/csv_table.hpp"
#include "tandem/error.hpp"
#include "tandem/scenario/taken.hpp"

namespace tandem::auto_scheme_tests {
namespace {

using charts::CsvTable;
using test::read_text;
using test::Said;
using test::Scratch;
using test::tandem;
using Words = std::vector<std::string>;

const std::string scene = R"toml(name = "left_out"
[parameters]
frequency_ratio = 9.3
[subsystems.fast]
source = "builtin:two_mass.fast"
[subsystems.slow]
source = "builtin:two_mass.slow"
[[connections]]
from = "slow.x2"
to = "fast.x2"
[[connections]]
from = "fast.x1"
to = "slow.x1"
[coordination]
scheme = "auto"
[span]
stop = 20
)toml";

class AutoScheme : public testing::Test {
 protected:
  AutoScheme() { folder_.write("s.toml", scene); }
  Said run(const Words& more) {
    Words words{"run", "s.toml", "--output", "o"};
    words.insert(words.end(), more.begin(), more.end());
    return tandem(folder_, words);
  }
  Words taken() const {
    return nlohmann::json::parse(read_text(folder_.path() / "o/results.json"))["scenario"]["taken"];
  }
  std::set<std::string> tried(const std::string& column) const {
    std::set<std::string> all;
    const auto table = CsvTable::read(folder_.path() / "o/advice/schemes.csv", {column});
    for (std::size_t k = 0; k < table.size(); ++k) all.insert(table[k].text(column));
    return all;
  }
  Scratch folder_;
};

/// A run of what was taken, stated in its place, has the same bytes.
TEST_F(AutoScheme, TakesTheSchemeOfTheSmallestPredictedError) {
  const Said said = run({});
  ASSERT_EQ(said.status, 0) << said.err;
  const auto best = advice::ranking(folder_.path() / "o/advice/schemes.csv").choices.front();
  EXPECT_NE(said.out.find("auto takes " + best.schedule + ", " + best.reconstruction), std::string::npos)
      << said.out;
  EXPECT_EQ(taken(), (Words{"coordination.schedule=" + best.schedule,
                            "connections[fast.x2].reconstruction=" + best.reconstruction,
                            "connections[slow.x1].reconstruction=" + best.reconstruction,
                            "subsystems.fast.parameters.steps_per_cycle=200",
                            "subsystems.slow.parameters.steps_per_cycle=200"}));
  EXPECT_EQ(best.steps, 0.5);
  const auto rows = read_text(folder_.path() / "o/results.csv");
  Words words = {"--set", "coordination.scheme=stated", "--set",
                 "connections.reconstruction=" + best.reconstruction};
  for (const std::string& one : taken()) words.insert(words.end(), {"--set", one});
  ASSERT_EQ(run(words).status, 0);
  EXPECT_EQ(read_text(folder_.path() / "o/results.csv"), rows);
}

TEST_F(AutoScheme, WithAToleranceTakesTheCheapest) {
  folder_.write("s.toml", scene + "[judge]\nquantity = 'fast.x1'\ntolerance = 0.3\n");
  const Said said = run({});
  ASSERT_EQ(said.status, 0) << said.err;
  const auto ranking = advice::ranking(folder_.path() / "o/advice/schemes.csv");
  const auto cheapest = ranking.cheapest();
  ASSERT_TRUE(cheapest);
  EXPECT_GT(cheapest->error, 1.01 * ranking.choices.front().error) << "not the best";
  EXPECT_EQ(taken()[1], "connections[fast.x2].reconstruction=" + cheapest->reconstruction);
  folder_.write("s.toml", scene + "[judge]\nquantity = 'fast.x1'\ntolerance = 1e-9\n");
  const Said none = run({});
  ASSERT_EQ(none.status, 0) << none.err;
  EXPECT_NE(none.out.find("and no other is within it"), std::string::npos) << none.out;
}

TEST_F(AutoScheme, WhatIsStatedStays) {
  ASSERT_EQ(run({"--set", "coordination.schedule=parallel"}).status, 0);
  EXPECT_EQ(tried("schedule"), std::set<std::string>{"parallel"});
  EXPECT_GT(tried("reconstruction").size(), 5U);
  EXPECT_EQ(tried("steps"), (std::set<std::string>{"0.5", "1", "2"})) << "steps_per_cycle is left out";
  const Words steps = {"--set", "subsystems.fast.parameters.steps_per_cycle=100", "--set",
                       "subsystems.slow.parameters.steps_per_cycle=100"};
  const auto with_steps = [&](Words words) {
    words.insert(words.end(), steps.begin(), steps.end());
    return run(words);
  };
  ASSERT_EQ(with_steps({"--set", "connections[fast.x2].reconstruction=lagrange2"}).status, 0);
  EXPECT_EQ(tried("steps"), std::set<std::string>{"1"});
  EXPECT_EQ(taken().size(), 2U);
  EXPECT_EQ(taken()[1].find("connections[slow.x1].reconstruction="), 0U);
  EXPECT_EQ(tried("schedule").size(), 4U);
  ASSERT_EQ(run({"--set", "connections.reconstruction=lagrange2"}).status, 0);
  EXPECT_EQ(tried("reconstruction"), std::set<std::string>{"stated"});
  const Said said = with_steps(
      {"--set", "connections.reconstruction=lagrange2", "--set", "coordination.schedule=parallel"});
  EXPECT_EQ(said.status, 2);
  EXPECT_NE(
      said.err.find("s.toml:15: coordination.scheme is auto, and the scenario leaves nothing out; allowed is "
                    "stated"),
      std::string::npos)
      << said.err;
}

/// The step of the file is a default that the scenario does not state.
TEST_F(AutoScheme, StepsThatAreLeftOutAreTaken) {
  const std::string oscillators = TANDEM_SOURCE_DIR "/scenarios/chains/chain.toml";
  const std::string subsystem = "[subsystems.{0}]\nsource = 'diagram:{0}.toml'\n",
                    connection = "[[connections]]\nfrom = '{}.x'\nto = '{}.partner'\n";
  for (const std::string name : {"a", "b"})
    folder_.write(name + ".toml", read_text(oscillators) + "\n[run]\nstep = 0.01\n");
  folder_.write("s.toml",
                "[coordination]\nscheme = 'auto'\n[span]\nstop = 3\n[judge]\nquantity = 'a.x'\ntolerance = "
                "0.05\n" +
                    fmt::format(fmt::runtime(subsystem), "a") + fmt::format(fmt::runtime(subsystem), "b") +
                    fmt::format(fmt::runtime(connection), "a", "b") +
                    fmt::format(fmt::runtime(connection), "b", "a"));
  const Said said = run({});
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_EQ(tried("steps"), (std::set<std::string>{"0.5", "1", "2"}));
  const auto all = taken();
  ASSERT_EQ(all.size(), 5U) << "the cheapest has steps that are twice as long";
  EXPECT_EQ(all[3], "subsystems.a.parameters.step=0.02");
  EXPECT_EQ(all[4], "subsystems.b.parameters.step=0.02");
  ASSERT_EQ(run({"--set", "subsystems.a.parameters.step=0.01"}).status, 0);
  EXPECT_EQ(tried("steps"), std::set<std::string>{"1"});
}

TEST_F(AutoScheme, ThoseWithEventsLeadWhereTheScheduleIsStated) {
  const std::string in = TANDEM_SOURCE_DIR "/scenarios/engine_linkage/";
  std::string text = read_text(in + "engine_linkage.toml");
  const auto replace = [&](const std::string& a, const std::string& b) {
    for (auto at = text.find(a); at != std::string::npos; at = text.find(a, at + b.size()))
      text.replace(at, a.size(), b);
  };
  replace("diagram:", "diagram:" + in), replace("mechanism:", "mechanism:" + in);
  replace("[coordination]", "[coordination]\nscheme = \"auto\"");
  for (auto at = text.find("reconstruction"); at != std::string::npos; at = text.find("reconstruction", at))
    text.erase(at, text.find('\n', at) - at);
  replace("order = [\"linkage\", \"engine\"]", "");
  folder_.write("s.toml", text);
  const Said said = run({"--set", "coordination.schedule=slowest-first", "--set", "span.stop=2", "--set",
                         "subsystems.engine.parameters.step=5e-4", "--no-reference"});
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_EQ(taken().at(1), "coordination.order=[\"engine\", \"linkage\"]");
}

TEST_F(AutoScheme, AResumedRunHasWhatWasTaken) {
  ASSERT_EQ(run({}).status, 0);
  const auto rows = read_text(folder_.path() / "o/results.csv"),
             json = read_text(folder_.path() / "o/results.json");
  ASSERT_EQ(run({"--checkpoint-every", "7"}).status, 0);
  std::filesystem::remove_all(folder_.path() / "o/advice");
  const Said said = run({"--resume", "o/checkpoint"});
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "o/advice")) << "nothing is predicted again";
  EXPECT_EQ(read_text(folder_.path() / "o/results.csv"), rows);
  EXPECT_EQ(read_text(folder_.path() / "o/results.json"), json);
  const Said stated = run({"--resume", "o/checkpoint", "--set", "coordination.scheme=stated", "--set",
                           "connections.reconstruction=lagrange1"});
  EXPECT_EQ(stated.status, 2) << "it is another run";
}

TEST_F(AutoScheme, OthersLookAtWhatIsStatedOrSayWhatIsMissing) {
  for (const Words& words :
       {Words{"validate", "s.toml"}, Words{"run", "s.toml", "--dry-run"}, Words{"info", "s.toml"}}) {
    const Said said = tandem(folder_, words);
    EXPECT_EQ(said.status, 0) << said.err;
    EXPECT_NE(said.out.find("note: coordination.scheme is auto"), std::string::npos) << said.out;
  }
  const Said said = tandem(folder_, {"stability", "s.toml"});
  EXPECT_EQ(said.status, 2);
  EXPECT_NE(
      said.err.find(
          "s.toml:15: coordination.scheme is auto, and no scheme has been taken; allowed here is stated"),
      std::string::npos)
      << said.err;
  const Said wrong = run({"--set", "coordination.scheme=best"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_NE(wrong.err.find("coordination.scheme"), std::string::npos) << wrong.err;
}

/// What is taken may come from a checkpoint that somebody else wrote.
TEST_F(AutoScheme, NothingButASchemeIsTaken) {
  const auto asked = scenario::read(folder_.path() / "s.toml");
  for (const char* bad :
       {"subsystems.fast.source=spawn:sh", "span.stop=3", "subsystems.fast.parameters.file=x",
        "subsystems.fast.command=[\"sh\"]", "coordination.start=cold", "record.ports=[]",
        "connections[fast.x2].from=slow.v2", "coordination.communication_step=nan", "x", ""})
    EXPECT_THROW(scenario::with_taken(asked, {bad}), Error) << bad;
  const auto good = scenario::with_taken(
      asked, {"coordination.schedule=parallel", "connections[fast.x2].reconstruction=hermite",
              "connections[slow.x1].reconstruction=mean", "subsystems.fast.parameters.steps_per_cycle=50"});
  EXPECT_FALSE(good.chooses);
  EXPECT_EQ(good.overrides, asked.overrides);
}

}  // namespace
}  // namespace tandem::auto_scheme_tests
