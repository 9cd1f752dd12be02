// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "command.hpp"

namespace tandem {
namespace {

using test::Said;
using test::Scratch;
using test::tandem;
using test::two_mass_file;

void expect_words(const Said& said, const std::vector<std::string>& words) {
  EXPECT_EQ(said.status, 0) << said.err;
  for (const std::string& word : words)
    EXPECT_NE(said.out.find(word), std::string::npos) << word << " not in: " << said.out;
}

TEST(InfoCommand, ShowsPortsUnitsAbilitiesAndFeedthroughOfASource) {
  const Scratch folder;
  expect_words(tandem(folder, {"info", "builtin:two_mass.fast_force?frequency_ratio=10"}),
               {"x2  unit m, start value none", "F  unit N, 0 time derivatives", "F at once from x2",
                "lands (can cut a step)", "first own step: 0.01 s"});
}

TEST(InfoCommand, ShowsAllSubsystemsAndConnectionsOfAScenario) {
  const Scratch folder;
  expect_words(tandem(folder, {"info", two_mass_file("force_delay.toml")}),
               {"slow: two_mass.slow", "fast: two_mass.fast", "fast.F -> slow.F  lagrange3, delay",
                "first own step: 0.25 s"});
}

TEST(InfoCommand, RefusesASourceThatIsNotThere) {
  const Scratch folder;
  const Said said = tandem(folder, {"info", "builtin:two_mass.fats"});
  EXPECT_EQ(said.status, 2);
  EXPECT_NE(said.err.find("did you mean 'builtin:two_mass.fast'?"), std::string::npos) << said.err;
}

TEST(ListCommand, NamesSourcesWordsAndScenarios) {
  const Scratch folder;
  expect_words(tandem(folder, {"list", std::string(TANDEM_SOURCE_DIR) + "/scenarios"}),
               {"builtin:two_mass.both", "fastest-first", "least_squaresD_EXTRA",
                "two_mass/force_plain.toml  The fast side"});
  expect_words(tandem(folder, {"list"}), {"no folder 'scenarios' here"});
  EXPECT_EQ(tandem(folder, {"list", "nowhere"}).status, 2);
}

TEST(ValidateCommand, SaysOkNotesAndAdvice) {
  const Scratch folder;
  expect_words(tandem(folder, {"validate", two_mass_file("force_plain.toml")}), {"force_plain.toml: ok"});
  expect_words(tandem(folder, {"validate", two_mass_file("force_plain.toml"), "--set",
                               "coordination.schedule=fastest-first"}),
               {"ok", "advice: output fast.F depends at once", "the error is smaller"});
}

TEST(InfoCommand, ShowsWhatAMechanismHas) {
  const Scratch folder;
  const std::string file = std::string(TANDEM_SOURCE_DIR) + "/scenarios/mechanisms/four_bar/four_bar.toml";
  expect_words(tandem(folder, {"info", file}),
               {"four_bar_5: a mechanism in the plane", "12 variables: B0.x, B0.y",
                "11 constraints: body crank0: ", "1 degrees of freedom", "redundant equations: none",
                "tangent matrix: 64 entries"});
  const Said said = tandem(folder, {"info", file, "--set", "a=1"});
  EXPECT_EQ(said.status, 2);
  EXPECT_NE(said.err.find("is a mechanism"), std::string::npos) << said.err;
}

TEST(Help, EveryCommandExplainsItsOptions) {
  const Scratch folder;
  expect_words(tandem(folder, {"run", "--help"}),
               {"--set", "--output", "--dry-run", "--profile", "--no-reference", "Exit status"});
  expect_words(tandem(folder, {"compare", "--help"}), {"--tolerance", "--columns", "Exit status"});
  expect_words(tandem(folder, {"validate", "--help"}), {"--set"});
  expect_words(tandem(folder, {"info", "--help"}), {"SOURCE|FILE"});
  expect_words(tandem(folder, {"list", "--help"}), {"DIR"});
  expect_words(tandem(folder, {"sweep", "--help"}), {"two_mass", "--pairs", "--resume", "--threads"});
  expect_words(tandem(folder, {"chart", "--help"}), {"two_mass", "--results", "--png", "gnuplot"});
  expect_words(tandem(folder, {"bench", "--help"}), {"exchange", "two_mass", "--output"});
  expect_words(tandem(folder, {"--help"}), {"run", "sweep", "chart", "compare", "info", "validate", "list",
                                            "bench", "--version", "--quiet", "--verbose", "--log"});
}

TEST(Help, TheVersionIsThatOfTheProject) {
  const Scratch folder;
  const Said said = tandem(folder, {"--version"});
  EXPECT_EQ(said.status, 0);
  EXPECT_EQ(said.out, TANDEM_VERSION "\n");
}

TEST(Help, AnUnknownCommandIsNamedWithTheNearest) {
  const Scratch folder;
  const Said said = tandem(folder, {"rnu", "x.toml"});
  EXPECT_EQ(said.status, 2);
  EXPECT_EQ(said.err,
            "tandem: command 'rnu' is not there; did you mean 'run'? There are: run, sweep, chart, compare, "
            "info, validate, list, bench\n");
}

}  // namespace
}  // namespace tandem
