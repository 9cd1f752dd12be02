// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// `tandem ladder`, with verdicts that do not depend on times.
#include <gtest/gtest.h>

#include "command.hpp"

namespace tandem {
namespace {

using test::contains;
using test::read_text;
using test::Said;
using test::Scratch;
using test::tandem;
using test::two_mass_file;

/// At frequency ratio 25 the scene's own degree 3 is within its 15 %, degree 0 is not (docs/two_mass.md).
TEST(LadderCommand, TellsTheSimplestRungOfTheTwoMassTest) {
  const Scratch folder;
  const Said said =
      tandem(folder, {"ladder", two_mass_file("force_plain.toml"), "--repetitions", "1", "--output", "l"});
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_TRUE(contains(said.out, "simplest within the tolerances: degree ")) << said.out;
  EXPECT_FALSE(contains(said.out, "simplest within the tolerances: degree 0")) << said.out;
  EXPECT_TRUE(contains(said.out, "differences from one system")) << said.out;
  EXPECT_EQ(read_text(folder.path() / "l/verdict.txt"), said.out.substr(0, said.out.find("wrote ")));
  EXPECT_TRUE(
      contains(read_text(folder.path() / "l/ladder.csv"), "\"one system\",fast.x1,1,max,0,0,0.15,0,"));
  for (const char* name : {"degree 0/results.csv", "one system/results.csv", "ladder.json"})
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "l" / name)) << name;
  EXPECT_EQ(tandem(folder, {"chart", "ladder"}).status, 2);
  const Said chart = tandem(folder, {"chart", "ladder", "--results", "l"});
  EXPECT_EQ(chart.status, 0) << chart.err;
  EXPECT_TRUE(contains(read_text(folder.path() / "l/ladder.gp"), "difference / tolerance"));
}

TEST(LadderCommand, ChangesItsVerdictWithTheTolerance) {
  const Scratch folder;
  const Said loose = tandem(folder, {"ladder", two_mass_file("force_plain.toml"), "--repetitions", "0"});
  std::string text = read_text(two_mass_file("force_plain.toml"));
  const std::string tolerance = "quantity = \"fast.x1\"\ntolerance = 0.15";
  ASSERT_TRUE(contains(text, tolerance));
  text.replace(text.find(tolerance), tolerance.size(), "quantity = \"fast.x1\"\ntolerance = 1e-9");
  folder.write("monolithic.toml", read_text(two_mass_file("monolithic.toml")));
  const Said none =
      tandem(folder, {"ladder", folder.write("strict.toml", text).string(), "--repetitions", "0"});
  EXPECT_EQ(loose.status, 0) << loose.err;
  EXPECT_TRUE(contains(none.out, "only the richest, one system, is left")) << none.out << none.err;
  EXPECT_FALSE(contains(loose.out, "only the richest"));
}

TEST(LadderCommand, RefusesScenesThatHaveNoneOrJudgeInAnotherUnit) {
  const Scratch folder;
  const Said none = tandem(folder, {"ladder", two_mass_file("staggered.toml")});
  EXPECT_EQ(none.status, 2);
  EXPECT_TRUE(contains(none.err, "staggered.toml") && contains(none.err, "[ladder]")) << none.err;
  const std::string scene = R"([subsystems.both]
source = "builtin:two_mass.both"
[span]
stop = 1
[[ladder.judged]]
quantity = "both.x1"
tolerance = 1
unit = "kg"
[[ladder.rungs]]
name = "a"
[[ladder.rungs]]
name = "b"
)";
  const Said unit = tandem(folder, {"ladder", folder.write("scene.toml", scene).string()});
  EXPECT_EQ(unit.status, 2);
  EXPECT_TRUE(contains(unit.err, "scene.toml:6") && contains(unit.err, "'kg'")) << unit.err;
}

/// x1 of the first rung is 0: as far off as the richest is large.
TEST(LadderCommand, TakesANumberForAQuantityThatAModelDoesNotMove) {
  const Scratch folder;
  const auto scene = [](const std::string& here) {
    return "[subsystems.both]\nsource = 'builtin:two_mass.both'\n[span]\nstop = 1\n"
           "[[ladder.judged]]\nquantity = 'both.x1'\ntolerance = 0.1\n"
           "[[ladder.judged]]\nquantity = 'both.x2'\ntolerance = 0.1\n"
           "[[ladder.rungs]]\nname = 'still'\noutputs = { 'both.x1' = " +
           here + " }\n[[ladder.rungs]]\nname = 'whole'\n";
  };
  const std::string file = folder.write("scene.toml", scene("0")).string();
  const Said said = tandem(folder, {"ladder", file, "--repetitions", "0", "--output", "l"});
  ASSERT_EQ(said.status, 0) << said.err;
  const std::string rows = read_text(folder.path() / "l/ladder.csv");
  EXPECT_TRUE(contains(rows, "\"still\",both.x1,1,max,1,1,0.1,0,,ok")) << rows;
  EXPECT_TRUE(contains(rows, "\"still\",both.x2,1,max,0,0,0.1,0,,ok")) << rows;
  EXPECT_TRUE(contains(said.out, "the next simpler, still, is not: both.x1 by 100 %")) << said.out;
  const Said wrong = tandem(folder, {"ladder", folder.write("wrong.toml", scene("true")).string()});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_TRUE(contains(wrong.err, "the output, or the number, that it is here")) << wrong.err;
}

/// One sine in rad and in degrees, and as a file whose heading has the unit: none is off.
class LadderUnits : public testing::Test {
 protected:
  LadderUnits() {
    for (const auto& [unit, amplitude] : {std::pair{"rad", "1"}, {"deg", "57.29577951308232"}})
      folder.write(std::string(unit) + ".toml",
                   std::string("[blocks]\ny = { kind = 'sine', frequency = 1, amplitude = ") + amplitude +
                       " }\n[outputs]\ny = { unit = '" + unit + "' }\n");
  }
  Said climb(const std::string& richest, const std::vector<std::string>& more = {}) const {
    folder.write(
        "l.toml",
        "[subsystems.d]\nsource = 'diagram:rad.toml'\nparameters = { step = 0.125 }\n[span]\nstop = 1\n"
        "[[ladder.judged]]\nquantity = 'd.y'\ntolerance = 1e-9\nunit = 'deg'\n"
        "[[ladder.rungs]]\nname = 'first'\nset = ['subsystems.d.source=diagram:deg.toml']\n"
        "[[ladder.rungs]]\nname = 'rich'\n" +
            richest);
    std::vector<std::string> words = {"ladder", "l.toml", "--output", "o", "--repetitions", "0"};
    words.insert(words.end(), more.begin(), more.end());
    return tandem(folder, words);
  }
  const Scratch folder;
};

TEST_F(LadderUnits, AreThoseOfTheJudgeForEachRung) {
  const Said said = climb("");
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_TRUE(contains(said.out, "simplest within the tolerances: first")) << said.out;
}

TEST_F(LadderUnits, ARungThatIsWrongIsNamed) {
  for (const auto& [set, word] : {std::pair{"subsystems.d.parameters.stepp=1", "'stepp' is not there"},
                                  {"record.clock=x", "'x'"},
                                  {"span.stop=late", "span.stop"}}) {
    const Said said = climb(std::string("set = ['") + set + "']\n");
    EXPECT_EQ(said.status, 2);
    EXPECT_TRUE(contains(said.err, "rung 'rich': ")) << said.err;
    EXPECT_TRUE(contains(said.err, word)) << said.err;
  }
  const Said said = climb("", {"--set", "ladder.judged=[{quantity='d.z', tolerance=1}]"});
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said.err, "gives none of the judged quantities: d.z")) << said.err;
}

TEST_F(LadderUnits, AreThoseOfTheHeadingOfAFile) {
  ASSERT_EQ(climb("").status, 0);
  std::string rows = read_text(folder.path() / "o/first/results.csv");
  folder.write("in_deg.csv", "time,d.y [deg]" + rows.substr(rows.find('\n')));
  Said said = climb("file = 'in_deg.csv'\n");
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_TRUE(contains(said.out, "simplest within the tolerances: first")) << said.out;
  folder.write("in_kg.csv", "time,d.y [kg]" + rows.substr(rows.find('\n')));
  said = climb("file = 'in_kg.csv'\n");
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said.err, "rung 'rich' gives d.y in 'kg'")) << said.err;
  said = climb("file = 'o/first'\n");
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said.err, "where the ladder writes")) << said.err;
}

/// Names that a rung has the other way round.
TEST_F(LadderUnits, AreConvertedOnceWhereNamesAreExchanged) {
  folder.write("two.toml",
               "[blocks]\na = { kind = 'sine', frequency = 1, amplitude = 1 }\nb = { kind = 'sine', "
               "frequency = 2, amplitude = 1 }\n"
               "[outputs]\na = { unit = 'rad' }\nb = { unit = 'rad' }\n");
  folder.write("two_in_deg.toml",
               "[blocks]\na = { kind = 'sine', frequency = 2, amplitude = 57.29577951308232 }\n"
               "b = { kind = 'sine', frequency = 1, amplitude = 57.29577951308232 }\n"
               "[outputs]\na = { unit = 'deg' }\nb = { unit = 'deg' }\n");
  folder.write(
      "l.toml",
      "[subsystems.d]\nsource = 'diagram:two.toml'\nparameters = { step = 0.125 }\n[span]\nstop = 1\n"
      "[[ladder.judged]]\nquantity = 'd.a'\ntolerance = 1e-9\nunit = 'rad'\n"
      "[[ladder.judged]]\nquantity = 'd.b'\ntolerance = 1e-9\nunit = 'rad'\n"
      "[[ladder.rungs]]\nname = 'first'\nset = ['subsystems.d.source=diagram:two_in_deg.toml']\n"
      "outputs = { 'd.a' = 'd.b', 'd.b' = 'd.a' }\n[[ladder.rungs]]\nname = 'rich'\n");
  const Said said = tandem(folder, {"ladder", "l.toml", "--output", "o", "--repetitions", "0"});
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_TRUE(contains(said.out, "simplest within the tolerances: first")) << said.out;
}

TEST_F(LadderUnits, AndTolerancesAreSetFromTheCommandLine) {
  ASSERT_EQ(climb("", {"--set", "ladder.judged[0].tolerance=7"}).status, 0);
  EXPECT_TRUE(contains(read_text(folder.path() / "o/ladder.csv"), ",7,"))
      << read_text(folder.path() / "o/ladder.csv");
  EXPECT_EQ(climb("", {"--set", "ladder.judged[0].tolerace=7"}).status, 2);
}

/// What an earlier ladder said is not beside rows that it does not know.
TEST_F(LadderUnits, AnOldVerdictGoesBeforeTheFirstRun) {
  ASSERT_EQ(climb("").status, 0);
  folder.write("grows.toml",
               "[blocks]\nfast = { kind = 'gain', input = 'y', gain = 100 }\n"
               "y = { kind = 'integrator', input = 'fast', initial = 1 }\n[outputs]\ny = { unit = 'rad' }\n");
  const Said said =
      climb("set = ['subsystems.d.source=diagram:grows.toml', 'subsystems.d.parameters.step=1e-3']\n");
  EXPECT_EQ(said.status, 1) << said.out << said.err;
  EXPECT_TRUE(contains(said.err, "the richest rung 'rich' failed")) << said.err;
  for (const char* name : {"ladder.csv", "verdict.txt", "ladder.json"})
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "o" / name)) << name;
}

}  // namespace
}  // namespace tandem
