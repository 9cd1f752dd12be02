// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "command.hpp"
#include "tandem/output/provenance.hpp"

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

/// A uniform rod of l = 1000 km, which swings with (3 g / 2 l)^(1/2) / 2 pi; its damping is zero without a
/// sign.
TEST(ModesCommand, ShowsSlowSwingsOfWhatIsLarge) {
  const Scratch folder;
  folder.write("rod.toml",
               "dimension = 2\ngravity = [0, -9.81]\n[points]\nO = { at = [0, 0], fixed = true }\n"
               "P = { at = [0, -1e6] }\n[rods]\nrod = { points = ['O', 'P'], mass = 1 }\n");
  expect_words(tandem(folder, {"modes", "rod.toml"}), {" 0.000611 Hz   0.0000  rod along x", "0 solutions"});
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

TEST(ValidateCommand, SaysOkAndNamesAdvise) {
  const Scratch folder;
  const std::string file = two_mass_file("force_plain.toml");
  expect_words(tandem(folder, {"validate", file, "--set", "coordination.schedule=fastest-first"}),
               {"force_plain.toml: ok", "tandem advise " + file});
}

TEST(ValidateCommand, LooksAtTheRungsOfALadder) {
  const Scratch folder;
  const auto with = [&](const std::string& quantity) {
    folder.write("s.toml",
                 "[subsystems.a]\nsource = 'builtin:two_mass.both'\n[span]\nstop = 1\n"
                 "[[ladder.judged]]\nquantity = '" +
                     quantity +
                     "'\ntolerance = 1\n"
                     "[[ladder.rungs]]\nname = 'x'\n[[ladder.rungs]]\nname = 'y'\n");
    return tandem(folder, {"validate", "s.toml"});
  };
  expect_words(with("a.x1"), {"s.toml: ok"});
  const Said set = tandem(folder, {"validate", "s.toml", "--set", "ladder.rungs[0].file=nope.toml"});
  EXPECT_NE(set.err.find("rung 'x': file 'nope.toml' is not there"), std::string::npos) << set.err;
  const Said wrong = with("a.nope");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_NE(wrong.err.find("rung 'x' gives none of the judged quantities: a.nope"), std::string::npos)
      << wrong.err;
}

/// One subsystem of that source, with an own step of 10 ms.
std::string data_scene(const std::string& source, const std::string& stop) {
  return "name = 's'\n[subsystems.a]\nsource = '" + source +
         "'\nparameters = { step = 0.01 }\n[span]\nstop = " + stop + "\n";
}

TEST(ValidateCommand, TellsOfDataThatEndBeforeTheSpan) {
  const Scratch folder;
  folder.write("data.csv", "time,f\n0,0\n1,1\n");
  folder.write("diagram.toml",
               "name = 'd'\n[blocks]\nf = { kind = 'csv', file = 'data.csv', column = 'f' }\n"
               "x = { kind = 'integrator', input = 'f' }\n[outputs]\nx = { unit = 'm' }\n");
  folder.write("mechanism.toml",
               "name = 'm'\ndimension = 2\n[points]\nO = { at = [0, 0], fixed = true }\nP = { at = [1, 0] }\n"
               "[rods]\nrod = { points = ['O', 'P'], mass = 1 }\n"
               "[inputs.push]\nunit = 'N'\nfile = 'data.csv'\ncolumn = 'f'\n"
               "[forces]\nf = { point = 'P', magnitude = 'push', direction = [1, 0] }\n"
               "[outputs]\nx = { position = 'P.x' }\n");
  for (const std::string source : {"diagram:diagram.toml", "mechanism:mechanism.toml"})
    for (const bool ends : {true, false}) {
      const auto file = folder.write("s.toml", data_scene(source, ends ? "2.0" : "1.0")).string();
      const Said said = tandem(folder, {"validate", file});
      EXPECT_EQ(said.status, 0) << said.err;
      EXPECT_EQ(said.out.find("note: subsystem 'a': ") != std::string::npos, ends) << said.out;
      EXPECT_EQ(said.out.find("the run to 2 s fails where they end") != std::string::npos, ends);
      EXPECT_EQ(tandem(folder, {"run", file}).status, ends ? 1 : 0);
    }
}

TEST(InfoCommand, ShowsWhatAMechanismHas) {
  const Scratch folder;
  const std::string file = std::string(TANDEM_SOURCE_DIR) + "/scenarios/mechanisms/four_bar/four_bar.toml";
  expect_words(tandem(folder, {"info", file}),
               {"four_bar_5: a mechanism in the plane", "12 variables: B0.x, B0.y",
                "11 constraints: body crank0: ", "1 degrees of freedom", "redundant equations: none",
                "tangent matrix: 64 entries"});
  expect_words(tandem(folder, {"info", file, "--set", "name=other"}), {"other: a mechanism in the plane"});
  const Said said = tandem(folder, {"info", file, "--set", "a=1"});
  EXPECT_EQ(said.status, 2);
  EXPECT_NE(said.err.find("--set a=1: unknown key 'a'"), std::string::npos) << said.err;
}

const std::string rod =
    "dimension = 2\n[points]\nO = { at = [0, 0], fixed = true }\nP = { at = [1, 0] }\n"
    "[rods]\na = { points = ['O', 'P'], mass = 1 }\n";

TEST(InfoCommand, TellsContradictoryEquationsFromRedundantOnes) {
  const Scratch folder;
  folder.write("twice.toml", rod + "[distances]\na = { points = ['O', 'P'] }\n");
  const Said twice = tandem(folder, {"info", "twice.toml"});
  expect_words(twice, {"2 constraints: body a: P . P, distance a", "1 degrees of freedom as assembled",
                       "redundant equations: "});
  EXPECT_EQ(twice.out.find("redundant equations: none"), std::string::npos);
  EXPECT_EQ(twice.out.find("contradictory"), std::string::npos);
  folder.write("against.toml", rod + "[distances]\na = { points = ['O', 'P'], length = 2 }\n");
  const Said against = tandem(folder, {"info", "against.toml"});
  EXPECT_EQ(against.status, 2);
  EXPECT_NE(against.out.find("redundant equations: none"), std::string::npos) << against.out;
  EXPECT_NE(against.out.find("contradictory equations: body a: P . P (off by "), std::string::npos)
      << against.out;
  EXPECT_NE(against.out.find("distance a (off by "), std::string::npos) << against.out;
  EXPECT_NE(against.err.find("the mechanism can't be assembled: constraint '"), std::string::npos)
      << against.err;
}

/// What `tandem run` would refuse, in its words; a part without a stop needs none.
TEST(InfoCommand, ChecksHowAMechanismIsToRun) {
  const Scratch folder;
  const std::vector<std::pair<std::string, std::string>> list = {
      {"stop = 1\nstep = 0.1\nstpo = 1\n",
       "m.toml:10: source 'mechanism:m.toml': parameter 'stpo' is not there"},
      {"stop = 1\nstep = 0.1\nbeta = 3\n", "m.toml:10: index-3 formulation: beta is 3"},
      {"stop = 1\nstep = 2\n", "m.toml:9: run.step is the number 2; allowed is up to 1 s"},
      {"stop = 1\n", "has no own step"},
      {"beta = 3\n", "m.toml:7: index-3 formulation: beta is 3"}};
  for (const auto& [run, words] : list) {
    folder.write("m.toml", rod + "[run]\n" + run);
    const Said said = tandem(folder, {"info", "m.toml"});
    EXPECT_EQ(said.status, 2) << run;
    EXPECT_NE(said.err.find(words), std::string::npos) << said.err;
  }
  folder.write("late.csv", "time,F\n1,0\n2,0\n");
  folder.write("m.toml",
               rod +
                   "[inputs]\nx = { unit = 'm', file = 'late.csv', column = 'F', interpolation = 'spline' }\n"
                   "[drives]\nd = { coordinate = 'P.x', motion = 'x' }\n");
  const Said late = tandem(folder, {"info", "m.toml"});
  EXPECT_EQ(late.status, 2);
  EXPECT_NE(late.err.find("m.toml: column 'F' of late.csv is asked for at t = 0 s"), std::string::npos)
      << late.err;
  folder.write("m.toml", rod + "[run]\nbeta = 0.2\n");
  expect_words(tandem(folder, {"info", "m.toml"}), {"1 degrees of freedom"});
}

TEST(Help, EveryCommandExplainsItsOptions) {
  const Scratch folder;
  expect_words(tandem(folder, {"run", "--help"}),
               {"--set", "--output", "--dry-run", "--profile", "--no-reference", "Exit status"});
  expect_words(tandem(folder, {"compare", "--help"}), {"--tolerance", "--columns", "Exit status"});
  expect_words(tandem(folder, {"validate", "--help"}), {"--set"});
  expect_words(tandem(folder, {"info", "--help"}), {"SOURCE|FILE"});
  expect_words(tandem(folder, {"list", "--help"}), {"DIR"});
  expect_words(tandem(folder, {"sweep", "--help"}), {"study", "--table", "--resume", "--threads", "--where"});
  expect_words(tandem(folder, {"ladder", "--help"}), {"--set", "--output", "--repetitions", "Exit status"});
  expect_words(tandem(folder, {"chart", "--help"}), {"study", "--results", "--png", "gnuplot"});
  expect_words(tandem(folder, {"bench", "--help"}), {"exchange", "two_mass", "--output"});
  expect_words(tandem(folder, {"--help"}), {"run", "sweep", "chart", "compare", "info", "validate", "list",
                                            "bench", "--version", "--quiet", "--verbose", "--log"});
}

TEST(Help, TheVersionIsThatOfTheProject) {
  const Scratch folder;
  const Said said = tandem(folder, {"--version"});
  EXPECT_EQ(said.status, 0);
  EXPECT_EQ(said.out, output::version() + "\n");
}

TEST(Help, AnUnknownCommandIsNamedWithTheNearest) {
  const Scratch folder;
  const Said said = tandem(folder, {"rnu", "x.toml"});
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(
      said.err.starts_with("tandem: command 'rnu' is not there; did you mean 'run'? There are: run, sweep"))
      << said.err;
  for (const char* command :
       {"compare", "info", "validate", "check", "modes", "list", "serve", "keys", "bench"})
    EXPECT_NE(said.err.find(std::string(", ") + command), std::string::npos) << command;
}

TEST(InfoCommand, TellsStatesOfElementsBesideVariables) {
  const Scratch folder;
  const std::string kart = std::string(TANDEM_SOURCE_DIR) + "/scenarios/kart/";
  expect_words(
      tandem(folder, {"info", kart + "spatial.toml"}),
      {"163 variables: ", "8 states of elements: tyre_FL slip", "149 constraints", "14 degrees of freedom"});
  EXPECT_EQ(tandem(folder, {"info", two_mass_file("two_mass.toml")}).out.find("states of"),
            std::string::npos);
}

/// w^2 = k / m: 4 times as stiff, twice the frequency.
TEST(ModesCommand, SetsValuesOfTheMechanismOrOfTheScenario) {
  const Scratch folder;
  folder.write(
      "m.toml",
      "dimension = 2\n[points]\nO = { at = [0, 0], fixed = true }\nP = { at = [1, 0] }\n"
      "[masses.load]\npoint = \"P\"\nmass = 1\n[springs.s]\npoints = [\"O\", \"P\"]\nstiffness = 39.4784176\n"
      "free = 1\n");
  expect_words(tandem(folder, {"modes", "m.toml"}), {"1.000 Hz"});
  expect_words(tandem(folder, {"modes", "m.toml", "--set", "springs.s.stiffness=157.91367"}), {"2.000 Hz"});
  const Said wrong = tandem(folder, {"modes", "m.toml", "--set", "springs.s.stifness=1"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_NE(wrong.err.find("'stifness'"), std::string::npos) << wrong.err;

  folder.write(
      "s.toml",
      "[subsystems.a]\nsource = \"mechanism:none.toml\"\nparameters = { step = 1 }\n[span]\nstop = 1\n");
  expect_words(tandem(folder, {"modes", "s.toml", "--set", "subsystems.a.source=mechanism:m.toml"}),
               {"1.000 Hz"});
  const Said port = tandem(folder, {"modes", "s.toml", "--set", "subsystems.a.source=mechanism:m.toml",
                                    "--set", "subsystems.a.inputs.push=1"});
  EXPECT_EQ(port.status, 2);
  EXPECT_NE(port.err.find("input 'push'"), std::string::npos) << port.err;
}

TEST(ModesCommand, TellsAStructureFromAMechanism) {
  const Scratch folder;
  folder.write(
      "truss.toml",
      "dimension = 2\n[points]\nA = { at = [0, 0], fixed = true }\nB = { at = [1, 0], fixed = true }\n"
      "C = { at = [0, 1] }\n[rods]\nAC = { points = ['A', 'C'], mass = 1 }\n"
      "BC = { points = ['B', 'C'], mass = 1 }\n");
  expect_words(tandem(folder, {"modes", "truss.toml"}),
               {"truss.toml: no modes, for its constraints leave no motion"});
}

TEST(ModesCommand, TakesInputsThatNothingGivesAsZeroAndSaysSo) {
  const Scratch folder;
  folder.write("pushed.toml",
               "dimension = 2\ngravity = [0, -9.81]\n[points]\nO = { at = [0, 0], fixed = true }\n"
               "P = { at = [0, -1] }\n[rods]\nrod = { points = ['O', 'P'], mass = 1 }\n"
               "[inputs]\npush = { unit = 'N' }\n"
               "[forces]\npush = { point = 'P', direction = [1, 0], magnitude = 'push' }\n");
  expect_words(tandem(folder, {"modes", "pushed.toml"}),
               {"inputs that are not known are taken as 0: push\n", " 0.611 Hz   0.0000  rod along x"});
}

TEST(InfoCommand, TakesAFileWithPointsForAMechanism) {
  const Scratch folder;
  folder.write("m.toml", "dimensoin = 2\n[points]\nO = { at = [0, 0], fixed = true }\n");
  folder.write("empty.toml", "");
  for (const char* command : {"info", "run"}) {
    const Said misspelt = tandem(folder, {command, "m.toml"}),
               empty = tandem(folder, {command, "empty.toml"});
    EXPECT_EQ(misspelt.status, 2);
    EXPECT_EQ(misspelt.err.find("subsystems"), std::string::npos) << misspelt.err;
    EXPECT_NE(empty.err.find("a mechanism, with points, or a diagram, with blocks"), std::string::npos)
        << empty.err;
  }
}

}  // namespace
}  // namespace tandem
