// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The metrics of studies that come from the map of a super-step, and the command.
#include <gtest/gtest.h>

#include "command.hpp"
#include "sources/all.hpp"
#include "tandem/charts/csv_table.hpp"
#include "tandem/scenario/scenario.hpp"
#include "tandem/stability/modes.hpp"

namespace tandem::stability_study_tests {
namespace {

const std::string scenes = TANDEM_SOURCE_DIR "/scenarios/";

const std::string study = "scenario = '" + scenes + R"toml(two_mass/two_mass.toml'
[set]
"parameters.frequency_ratio" = "$ratio"
[[tables.t.blocks]]
axes = [{ ratio = [10, 25, 90] }]
[metrics]
spectral_radius = {}
)toml";

TEST(StabilityStudy, HasRadiusDampingAndDetuningWithoutARun) {
  const test::Scratch folder;
  folder.write("s.toml", study + "damping = { state = 'fast.x1' }\ndetuning = {}\n");
  const auto said = test::tandem(folder, {"sweep", "s.toml", "--output", "o"});
  ASSERT_EQ(said.status, 0) << said.err;
  const auto rows = charts::CsvTable::read(folder.path() / "o/t.csv", {});
  for (std::size_t k = 0; k < 2; ++k) {
    const auto found =
        stability::stability(scenario::read(scenes + "two_mass/two_mass.toml",
                                            {"parameters.frequency_ratio=" + rows[k].text("ratio")}),
                             all_sources());
    EXPECT_NEAR(rows[k].number("spectral_radius"), found.radius, 1e-14);
    EXPECT_NEAR(rows[k].number("damping"), found.modes[0].scheme_damping - found.modes[0].damping, 1e-12);
    EXPECT_NEAR(rows[k].number("detuning"), found.modes[0].detuning(), 1e-12);
  }
  EXPECT_EQ(rows[2].text("damping"), "");
  EXPECT_EQ(rows[2].text("note"), "the scheme has no mode like that of fast.x1, fast.v1");
}

TEST(StabilityStudy, WrongStatesAreRefused) {
  const test::Scratch folder;
  for (const auto& [metric, why] :
       {std::pair("damping = { state = 'fast.x' }", "state 'fast.x' is not there"),
        std::pair("damping = { mode = 1 }", "metrics.damping.of is missing"),
        std::pair("e = { of = 'fast.x1', state = 'fast.x1' }", "state")}) {
    folder.write("s.toml", study + metric + "\n");
    const auto said = test::tandem(folder, {"sweep", "s.toml", "--output", "x"});
    EXPECT_EQ(said.status, 2) << said.out;
    EXPECT_NE(said.err.find(why), std::string::npos) << said.err;
  }
}

TEST(StabilityCommand, TellsRadiusAndModes) {
  const test::Scratch folder;
  const auto said = test::tandem(folder, {"stability", scenes + "two_mass/two_mass.toml"});
  EXPECT_EQ(said.status, 0) << said.err;
  for (const char* words : {"unstable", "super-step: 0.25 s, own steps: fast 25, slow 1",
                            "spectral radius: 1.0000", "fast.x1, fast.v1", "largest stable step: 0.025"})
    EXPECT_NE(said.out.find(words), std::string::npos) << said.out;
}

TEST(StabilityCommand, DrawsAMapOfTwoKeys) {
  const test::Scratch folder;
  const auto map = [&](const std::string& x, const std::string& y) {
    return test::tandem(folder,
                        {"stability", scenes + "oscillator/udc.toml", "--map", x, y, "--output", "m"});
  };
  const auto said = map("x=constants.step:0.5e-3:4e-3:4", "y=constants.c:10:1000:3:log");
  ASSERT_EQ(said.status, 0) << said.err;
  const auto table =
      charts::CsvTable::read(folder.path() / "m/stability_map.csv", {"x", "y", "spectral_radius"});
  EXPECT_EQ(table.size(), 15U) << "0.001 is among 0.0005, 0.001667, ..; 100 is there already";
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "m/stability_map.svg"));
  for (std::size_t k = 0; k < table.size(); ++k)
    if (table[k].number("x") == 0.001 && table[k].number("y") == 100.0) {
      EXPECT_NEAR(table[k].number("spectral_radius"), 1.0, 1e-9);
    }
  for (const auto& [x, y, why] :
       {std::tuple("x=constants.step:1:0.5:4", "y=constants.c:1:2:3", "does not rise"),
        {"x=constants.step:1:2:4", "z=constants.c:1:2:3", "y is missing"},
        {"x=constants.step:a:2:4", "y=constants.c:1:2:3", "'a' is no number"},
        {"x=constants.step:0:2:4:log", "y=constants.c:1:2:3", "FROM is 0"},
        {"x=constants.step:1:2:400", "y=constants.c:1:2:3", "COUNT is 400"},
        {"x=constants.stop:1:2:4", "y=constants.c:1:2:3", "'stop' is not there"}}) {
    const auto wrong = map(x, y);
    EXPECT_EQ(wrong.status, 2) << wrong.out;
    EXPECT_NE(wrong.err.find(why), std::string::npos) << wrong.err;
  }
}

TEST(AdviseCommand, RanksSchemesAndWritesTheLinesOfOne) {
  const test::Scratch folder;
  const auto said = test::tandem(folder, {"advise", scenes + "two_mass/two_mass.toml", "--set",
                                          "span.stop=20", "--show", "2", "--output", "a"});
  ASSERT_EQ(said.status, 0) << said.err;
  for (const char* words :
       {"fast (builtin:two_mass.fast): a linear model of order 2", "of the tolerance off that of its models",
        "smallest error:", "cheapest within the tolerance:", "fastest mode 1 Hz (fast.x1, fast.v1)",
        "advice.toml"})
    EXPECT_NE(said.out.find(words), std::string::npos) << said.out;
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "a/advice.toml"));
  const auto wrong = test::tandem(folder, {"advise", "not_there.toml"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_NE(wrong.err.find("not_there.toml"), std::string::npos) << wrong.err;
}

}  // namespace
}  // namespace tandem::stability_study_tests
