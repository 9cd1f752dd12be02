// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// tandem export SCENARIO FILE.ssp: scenarios as systems of SSP, and back.
#include <gtest/gtest.h>

#include <random>

#include "command.hpp"
#include "tandem/scenario/scenario.hpp"

namespace tandem::test {
namespace {

/// T x' = u + w - x from x = first. The step of its table [run] is not that of a scenario.
std::string lag_diagram(const std::string& in, const std::string& out) {
  return "[parameters]\nT = { value = 0.3, unit = 's' }\nfirst = { value = 0.2, unit = '1' }\n[inputs]\nu = "
         "{ unit = '" +
         in + "' }\nw = { unit = '" + in +
         "' }\n[blocks]\nrate = { kind = 'sum', inputs = ['u', 'w', 'state'], gains = ['$(1 / T)', '$(1 / "
         "T)', "
         "'$(-1 / T)'] }\nstate = { kind = 'integrator', input = 'rate', initial = '$first' }\n"
         "x = { kind = 'gain', input = 'state', gain = 1 }\n[outputs]\nx = { unit = '" +
         out + "' }\n[run]\nstep = 0.9\nstop = 1\nintegrator = 'erkstep_fixed'\n";
}

std::string run_and_read(const Scratch& folder, const std::string& file, const std::string& results) {
  const Said said = tandem(folder, {"--quiet", "run", file, "--output", results});
  EXPECT_EQ(said.status, 0) << said.err;
  return read_text(folder.path() / results / "results.csv");
}

Said exported(const Scratch& folder, const std::string& text, const std::string& version = "2") {
  folder.write("s.toml", text);
  return tandem(folder, {"export", "s.toml", "s.ssp", "--fmi", version});
}

/// Of x'' = u - x, whose second derivative follows u at once.
std::string mass_diagram() {
  return "[inputs]\nu = { unit = 'm' }\n[blocks]\na = { kind = 'sum', inputs = ['u', 'x'], gains = [1, -1] "
         "}\nv = { kind "
         "= 'integrator', input = 'a' }\nx = { kind = 'integrator', input = 'v', initial = 1 }\n[outputs]\nx "
         "= { unit = "
         "'m', from = 'x' }\n[run]\nstep = 0.01\nstop = 1\nintegrator = 'erkstep_fixed'\n";
}

/// A ring of lags whose steps fit into each other, coupled by held values.
std::string random_ring(const Scratch& folder, std::mt19937& random) {
  const auto pick = [&](int most) { return std::uniform_int_distribution<int>(0, most)(random); };
  const std::vector<std::string> schedules = {"slowest-first", "fastest-first", "parallel"};
  const int count = 2 + pick(2);
  const bool equal = pick(1) == 0;  // steps
  std::string text = "[coordination]\nschedule = \"" +
                     schedules[static_cast<std::size_t>(pick(equal ? 2 : 1))] +
                     "\"\n[span]\nstart = 0.5\nstop = 2.5\n";
  for (int k = 0; k < count; ++k) {
    const std::string name = "m" + std::to_string(k), units[] = {"m", "mm", "km"};
    folder.write(name + ".toml", lag_diagram(units[pick(2)], units[pick(2)]));
    text += "[subsystems." + name + "]\nsource = \"diagram:" + name +
            ".toml?T=" + std::to_string(1 + pick(3)) +
            "\"\nparameters = { step = " + (equal || pick(1) == 0 ? "0.0625" : "0.03125") +
            ", first = " + std::to_string(pick(4)) + " }\ninputs = { w = " + std::to_string(pick(3)) + " }\n";
  }
  for (int k = 0; k < count; ++k)
    text += "[[connections]]\nfrom = \"m" + std::to_string(k) + ".x\"\nto = \"m" +
            std::to_string((k + 1) % count) + ".u\"\n" + (k == 0 && equal ? "memory = true\n" : "") +
            "reconstruction = \"" + (equal ? "lagrange0" : "matched_hold") +
            "\"\ngain = " + std::to_string(0.25 * pick(4)) + "\noffset = " + std::to_string(pick(2)) +
            "\nconvert = true\n";
  return text;
}

TEST(SystemExport, RandomRingsOfHeldValuesComeBackWithTheirBits) {
  std::mt19937 random(20261127);
  for (int trial = 0; trial < 8; ++trial) {
    const Scratch folder;
    const std::string text = random_ring(folder, random);
    SCOPED_TRACE(text);
    const Said said = exported(folder, text, trial % 2 == 0 ? "2" : "3");
    ASSERT_EQ(said.status, 0) << said.err;
    EXPECT_EQ(run_and_read(folder, "s.ssp", "back"), run_and_read(folder, "s.toml", "there"));
  }
}

const std::string two_lags =
    "[subsystems.a]\nsource = \"diagram:lag.toml\"\nparameters.step = 0.01\ninputs.w = 1\n"
    "[subsystems.b]\nsource = \"diagram:lag.toml\"\nparameters = { step = 0.01, T = 0.1 }\ninputs.w = 0\n"
    "[[connections]]\nfrom = \"a.x\"\nto = \"b.u\"\nreconstruction = \"lagrange3\"\n"
    "[[connections]]\nfrom = \"b.x\"\nto = \"a.u\"\nreconstruction = \"lagrange2\"\n[span]\nstop = 1\n";

TEST(SystemExport, TellsWhatDegreesBecomeAndIsTheSameAgain) {
  const Scratch folder;
  folder.write("lag.toml", lag_diagram("m", "m"));
  const Said said = exported(folder, two_lags);
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_TRUE(contains(said.out, "s.ssp: SSP 1.0, 2 components, 2 connections")) << said.out;
  EXPECT_TRUE(contains(said.out, "b: inputs of degree 3 are given by derivatives of order 2")) << said.out;
  EXPECT_FALSE(contains(said.out, "a: inputs")) << said.out;
  EXPECT_FALSE(contains(said.out, "differs")) << said.out;
  ASSERT_EQ(tandem(folder, {"export", "s.ssp", "again.ssp"}).status, 0);
  EXPECT_EQ(read_text(folder.path() / "s.ssp"), read_text(folder.path() / "again.ssp"));
}

TEST(SystemExport, TellsWhatAnFmuCantBeGiven) {
  const Scratch folder;
  folder.write("lag.toml", lag_diagram("m", "m"));
  const Said three = exported(folder, two_lags, "3");
  for (const char* sentence :
       {"b: inputs of degree 3 are given as their mean over each step", "a: inputs of degree 2"})
    EXPECT_TRUE(contains(three.out, sentence)) << three.out;
  std::string text = two_lags;
  text.replace(text.find("0.01"), 4, "0.02");
  const Said shorter = exported(folder, text);
  EXPECT_TRUE(contains(shorter.out, "a: b has shorter steps")) << shorter.out;
  EXPECT_FALSE(contains(shorter.out, "b: a has")) << shorter.out;
}

/// Degree 2 is what derivatives give: rounding alone is left.
TEST(SystemExport, ComesBackAsExactAsItsSource) {
  const Scratch folder;
  folder.write("lag.toml", lag_diagram("m", "m"));
  std::string text = two_lags;
  text.replace(text.find("lagrange3"), 9, "lagrange1");
  ASSERT_EQ(exported(folder, text).status, 0);
  run_and_read(folder, "s.ssp", "back"), run_and_read(folder, "s.toml", "there");
  const Said said = tandem(folder, {"compare", "there", "back", "--tolerance", "1e-13"});
  EXPECT_EQ(said.status, 0) << said.out << said.err;
}

/// A time of the start that is not zero, a decimal step, FMUs with units, values and outputs of their own.
TEST(SystemExport, KeepsWhatTheScenarioSays) {
  const Scratch folder;
  folder.write("lag.toml", lag_diagram("mm", "mm"));
  const std::string text =
      "[coordination]\norder = [\"b\", \"a\"]\n[span]\nstart = 1\nstop = 2\n"
      "[subsystems.a]\nsource = \"diagram:lag.toml\"\nparameters.step = 0.01\ninputs.w = 1\nland = "
      "\"never\"\n"
      "[subsystems.b]\nsource = \"fmu:" TANDEM_FMUS
      "/mass.fmu?set.k=3\"\nisolate = true\n"
      "parameters = { step = 0.01, outputs = { a = true, k = false }, unit = { x = \"\", v = \"mm/s\" } }\n"
      "[[connections]]\nfrom = \"a.x\"\nto = \"b.u\"\nconvert = true\nreconstruction = \"matched_hold\"\n"
      "[[connections]]\nfrom = \"b.x\"\nto = \"a.u\"\nreconstruction = \"matched_hold\"\n";
  const Said said = exported(folder, text);
  ASSERT_EQ(said.status, 0) << said.err;
  const auto there = scenario::read(folder.path() / "s.toml"), back = scenario::read(folder.path() / "s.ssp");
  EXPECT_EQ(back.coordination.order, there.coordination.order);
  EXPECT_EQ(back.coordination.landing, there.coordination.landing);
  EXPECT_TRUE(back.subsystems.at(1).isolated);
  EXPECT_EQ(run_and_read(folder, "s.ssp", "back"), run_and_read(folder, "s.toml", "there"));
}

TEST(SystemExport, OfAFileAloneTakesItsOverrides) {
  const Scratch folder;
  folder.write("lag.toml", lag_diagram("m", "m") + "inputs = { u = 1, w = 0 }\n");
  const std::vector<std::string> set = {"--set", "parameters.T.value=0.5", "--set", "run.step=0.125"};
  const auto with_set = [&](std::vector<std::string> words) {
    words.insert(words.end(), set.begin(), set.end());
    const Said said = tandem(folder, words);
    EXPECT_EQ(said.status, 0) << said.err;
  };
  with_set({"export", "lag.toml", "s.ssp"});
  with_set({"--quiet", "run", "lag.toml", "--output", "there"});
  EXPECT_EQ(run_and_read(folder, "s.ssp", "back"), read_text(folder.path() / "there/results.csv"));
}

TEST(SystemExport, WhatSamplesIsTold) {
  const Scratch folder;
  folder.write("lag.toml", lag_diagram("m", "m"));
  folder.write("hold.toml",
               "[inputs]\nu = { unit = 'm' }\n[blocks]\nx = { kind = 'sample', input = 'u', period = 0.1 }\n"
               "[outputs]\nx = { unit = 'm' }\n");
  const Said said = exported(
      folder,
      "[coordination]\norder = [\"a\"]\n[subsystems.a]\nsource = \"diagram:lag.toml\"\nparameters.step = "
      "0.01\n"
      "inputs.w = 1\n[subsystems.c]\nsource = \"diagram:hold.toml\"\n[[connections]]\n"
      "from = \"a.x\"\nto = \"c.u\"\nreconstruction = \"lagrange1\"\n[[connections]]\nfrom = \"c.x\"\nto = "
      "\"a.u\"\n[span]\nstop = 1\n");
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_TRUE(contains(said.out, "c: samples")) << said.out;
  run_and_read(folder, "s.ssp", "back");
}

TEST(SystemExport, WhatHasNoWordsIsNamed) {
  const Scratch folder;
  folder.write("lag.toml", lag_diagram("m", "m"));
  const std::string
      a = "[subsystems.a]\nsource = \"diagram:lag.toml\"\nparameters.step = 0.01\ninputs.w = 1\n",
      b = "[subsystems.b]\nsource = \"diagram:lag.toml\"\nparameters.step = 0.01\n",
      to_b = "[[connections]]\nfrom = \"a.x\"\nto = \"b.u\"\nreconstruction = \"lagrange1\"\n",
      end = "[span]\nstop = 1\n";
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases = {
      {a + "inputs.u = 0\n[subsystems.p]\ncommand = [\"x\"]\n" + end,
       {"'p' is command", "does not go along"}},
      {a + "inputs.u = { times = [0, 1], values = [0, 1] }\n" + end, {"a.u is given over time"}},
      {a + "inputs.u = 0\n" + b + "inputs.w = 0\n" + to_b + "add = true\n" + to_b + "add = true\ngain = 2\n" +
           end,
       {"from a.x to b.u", "adds to others"}}};
  for (const auto& [text, sentences] : cases) {
    const Said said = exported(folder, text);
    EXPECT_EQ(said.status, 2) << text;
    for (const std::string& sentence : sentences) EXPECT_TRUE(contains(said.err, sentence)) << said.err;
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "s.ssp"));
  }
  const Said none = tandem(folder, {"export", "s.toml", "s.zip"});
  EXPECT_EQ(none.status, 2);
  EXPECT_TRUE(contains(none.err, "ends in .fmu, or in .ssp")) << none.err;
}

/// The first has a constant for its input, and its outputs keep their derivatives.
TEST(SystemExport, TheRunThatComesBackStartsAsTheScenarioDoes) {
  const Scratch folder;
  folder.write("mass.toml", mass_diagram());
  const std::string text =
      "[subsystems.a]\nsource = \"diagram:mass.toml\"\ninputs.u = 0.5\n[subsystems.b]\nsource = "
      "\"diagram:mass.toml\"\n[[connections]]\nfrom = \"a.x\"\nto = \"b.u\"\nreconstruction = "
      "\"lagrange2\"\ngain = 0.5\n"
      "[coordination]\nschedule = \"parallel\"\n[span]\nstop = 1\n";
  ASSERT_EQ(exported(folder, text).status, 0);
  EXPECT_EQ(run_and_read(folder, "s.toml", "source"), run_and_read(folder, "s.ssp", "back"));
}

TEST(SystemExport, TellsOfEventsThatOthersSeeLate) {
  const Scratch folder;
  const Said said =
      tandem(folder, {"export", TANDEM_SOURCE_DIR "/scenarios/engine_linkage/thesis.toml", "s.ssp"});
  EXPECT_TRUE(contains(said.out, "engine: has events, which others see at the ends of its steps alone"))
      << said.out;
}

}  // namespace
}  // namespace tandem::test
