// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Diagrams in blocks, evaluated always or at events.
#include <gtest/gtest.h>

#include <cmath>

#include "diagram_run.hpp"
#include "refusal.hpp"
#include "scratch.hpp"

namespace tandem::engine {
namespace {

using test::DiagramRun;
using test::refuses;

/// A lag with a gain, as a diagram.
const std::string lag_text =
    "[parameters]\nT = { value = 1, unit = 's' }\n[inputs]\nu = { unit = '1' }\n[blocks]\n"
    "rest = { kind = 'sum', inputs = ['u', 'y'], gains = [1, -1] }\n"
    "rate = { kind = 'quotient', numerator = 'rest', denominator = '$T' }\n"
    "y = { kind = 'integrator', input = 'rate' }\n[outputs]\nout = { unit = '1', from = 'y' }\n";

class Nested : public testing::Test {
 protected:
  Program compiled(const std::string& text) const {
    return compile(read_diagram(folder.write("d.toml", text)));
  }
  const test::Scratch folder;
};

TEST_F(Nested, HaveParametersInputsAndOutputsOfTheirOwn) {
  folder.write("lag.toml", lag_text);
  const Program p = compiled(
      "[parameters]\nslow = { value = 2, unit = 's' }\n[blocks]\n"
      "first = { kind = 'diagram', file = 'lag.toml', u = 3 }\n"
      "second = { kind = 'diagram', file = 'lag.toml', u = 1, T = '$slow' }\n"
      "y = { kind = 'sum', inputs = ['first', 'second.out'] }\n[outputs]\ny = { unit = '1' }\n");
  EXPECT_EQ(p.state_names, (std::vector<std::string>{"first.y", "second.y"}));
  Simulation s(p, nullptr, make_integrator({}));
  s.start(0.0);
  for (int k = 1; k <= 200; ++k) s.step(0.005 * k);
  EXPECT_NEAR(s.output(0), 3.0 * (1.0 - std::exp(-1.0)) + 1.0 - std::exp(-0.5), 1e-9);
}

TEST_F(Nested, StandInTheFileItself) {
  const Program p = compiled(
      "[blocks.twice]\nkind = 'diagram'\nu = 'time'\n[blocks.twice.diagram.inputs]\nu = { unit = 's' }\n"
      "[blocks.twice.diagram.blocks]\ng = { kind = 'gain', input = 'u', gain = 2 }\n"
      "[blocks.twice.diagram.outputs]\ng = { unit = 's' }\n[outputs]\nx = { unit = 's', from = 'twice.g' "
      "}\n");
  Simulation s(p, nullptr, make_integrator({}));
  s.start(4.0);
  EXPECT_EQ(s.output(0), 8.0);
}

/// Was 28 s and a gigabyte for 18 files of two blocks.
TEST_F(Nested, FilesThatContainEachOtherTwiceAreRefusedByTheirNumberOfBlocks) {
  const std::string u = "[inputs]\nu = { unit = '1' }\n[blocks]\n",
                    y = "[outputs]\ny = { unit = '1', from = 'a' }\n";
  folder.write("d30.toml", u + "a = { kind = 'gain', input = 'u', gain = 2 }\n" + y);
  for (int k = 0; k < 30; ++k) {
    const std::string next =
        " = { kind = 'diagram', file = 'd" + std::to_string(k + 1) + ".toml', u = 'u' }\n";
    folder.write("d" + std::to_string(k) + ".toml", u + "a" + next + "b" + next + y);
  }
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"d0.toml", "there are more than 20000 blocks"},
                      [&] { read_diagram(folder.path() / "d0.toml"); }));
  EXPECT_EQ(read_diagram(folder.path() / "d18.toml").blocks.size(), 2U);
}

TEST_F(Nested, AreBoundedInDepth) {
  const std::string u = "[inputs]\nu = { unit = '1' }\n[blocks]\n",
                    y = "[outputs]\ny = { unit = '1', from = 'a' }\n";
  folder.write("c200.toml", u + "a = { kind = 'gain', input = 'u', gain = 2 }\n" + y);
  for (int k = 0; k < 200; ++k)
    folder.write("c" + std::to_string(k) + ".toml",
                 u + "a = { kind = 'diagram', file = 'c" + std::to_string(k + 1) + ".toml', u = 'u' }\n" + y);
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument,
                      {"c50.toml:4: diagrams stand in each other more than 50 deep"},
                      [&] { read_diagram(folder.path() / "c0.toml"); }));
  EXPECT_NO_THROW(read_diagram(folder.path() / "c150.toml"));
}

TEST_F(Nested, AreNamedWithTheirBlockInMessages) {
  folder.write("lag.toml", lag_text);
  const auto code = ErrorCode::invalid_argument;
  const auto refused = [&](const std::string& keys, const std::vector<std::string>& words) {
    return refuses(code, words, [&] {
      compiled("[blocks]\nb = { kind = 'diagram', " + keys + " }\n[outputs]\nb = { unit = '1' }\n");
    });
  };
  EXPECT_TRUE(refused("file = 'lag.toml'", {"d.toml:2", "block 'b' of kind diagram has no u"}));
  EXPECT_TRUE(refused("file = 'lag.toml', u = 1, v = 2", {"d.toml:2", "'v'", "u"}));
  EXPECT_TRUE(refused("file = 'lag.toml', u = 1, T = 'time'", {"d.toml:2", "T is the text 'time'"}));
  EXPECT_TRUE(refused("u = 1", {"d.toml:2", "blocks.b.file is missing"}));
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"d.toml:2", "gone.toml' is not there"},
                      [&] { compiled("[blocks]\nb = { kind = 'diagram', file = 'gone.toml' }\n"); }));
  folder.write("bad.toml",
               "[blocks]\nx = { kind = 'gain', input = 'q', gain = 2 }\n[outputs]\nx = { unit = '1' }\n");
  EXPECT_TRUE(refused("file = 'bad.toml'", {"bad.toml:2", "block 'b.", "signal 'b.q' is not there"}));
  folder.write("loop.toml",
               "[blocks]\nx = { kind = 'gain', input = 'x', gain = 2 }\n[outputs]\nx = { unit = '1' }\n");
  EXPECT_TRUE(refused("file = 'loop.toml'", {"algebraic loop", "b.x"}));
}

TEST_F(Nested, AreRefusedWhereTheyContainThemselves) {
  folder.write("one.toml",
               "[blocks]\nx = { kind = 'diagram', file = 'two.toml' }\n[outputs]\nx = { unit = '1' }\n");
  folder.write("two.toml",
               "[blocks]\ny = { kind = 'diagram', file = 'one.toml' }\n[outputs]\ny = { unit = '1' }\n");
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"two.toml:2", "one.toml > two.toml > one.toml"},
                      [&] { read_diagram(folder.path() / "one.toml"); }));
}

/// A diagram whose output is its input makes no block of its own.
TEST_F(Nested, AreRefusedAsACircleOfNames) {
  folder.write("wire.toml",
               "[inputs]\nu = { unit = '1' }\n[blocks]\nc = { kind = 'constant', value = 1 }\n[outputs]\ny = "
               "{ unit = '1', from = 'u' }\n");
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"stands for itself"}, [&] {
    compiled(
        "[blocks]\nw = { kind = 'diagram', file = 'wire.toml', u = 'w.y' }\n[outputs]\nw = { unit = '1' }\n");
  }));
}

/// At each full 0.1 s: the number of events so far, and the time since the last one.
const std::string counter =
    "[blocks.c]\nkind = 'triggered'\nperiod = 0.1\noffset = 0.1\nnow = 'time'\n"
    "[blocks.c.diagram.inputs]\nnow = { unit = 's' }\n[blocks.c.diagram.blocks]\n"
    "count = { kind = 'gain', input = 'before', gain = 1, offset = 1 }\n"
    "before = { kind = 'unit_delay', input = 'count' }\n"
    "last = { kind = 'unit_delay', input = 'now', initial = -1 }\n"
    "since = { kind = 'sum', inputs = ['now', 'last'], gains = [1, -1] }\n"
    "small = { kind = 'saturation', input = 'count', low = 0, high = 3 }\n"
    "[blocks.c.diagram.outputs]\ncount = { unit = '1' }\nsince = { unit = 's' }\nsmall = { unit = '1' }\n"
    "[outputs]\ncount = { unit = '1', from = 'c.count' }\nsince = { unit = 's', from = 'c.since' }\n"
    "small = { unit = '1', from = 'c.small' }\n";

TEST(Triggered, AreEvaluatedAtTheirEventsAlone) {
  DiagramRun run(counter);
  run.run(0.55, 11);
  EXPECT_EQ(run.simulation.output(0), 5.0);
  EXPECT_NEAR(run.simulation.output(1), 0.1, 1e-15);
  EXPECT_EQ(run.simulation.output(2), 3.0);
  EXPECT_LT(run.program.step_operations, static_cast<int>(run.program.operations.size()));
}

/// A wheel that turns with 2 rad/s gives the time at each full radian.
TEST(Triggered, FollowTheAngleOfACrank) {
  DiagramRun run(
      "[blocks.angle]\nkind = 'integrator'\ninput = 2\n[blocks.full]\nkind = 'passes'\ninput = "
      "'angle'\nevery = 1\n"
      "[blocks.at]\nkind = 'triggered'\ntrigger = 'full'\nt = 'time'\n"
      "[blocks.at.diagram.inputs]\nt = { unit = 's' }\n[blocks.at.diagram.blocks]\n"
      "y = { kind = 'gain', input = 't', gain = 1 }\n[blocks.at.diagram.outputs]\ny = { unit = 's' }\n"
      "[outputs]\nat = { unit = 's' }\n");
  run.run(1.2, 5);
  EXPECT_NEAR(run.simulation.output(0), 1.0, 1e-12);
}

TEST(Triggered, RefuseWhatHasStatesOrEvents) {
  const auto code = ErrorCode::invalid_argument;
  const auto refused = [&](const std::string& block, const std::vector<std::string>& words) {
    return refuses(code, words, [&] {
      compile(read_diagram(
          "d", "[blocks.c]\nkind = 'triggered'\nperiod = 1\n[blocks.c.diagram.blocks]\nx = { " + block +
                   " }\n[blocks.c.diagram.outputs]\nx = { unit = '1' }\n[outputs]\nc = "
                   "{ unit = '1' }\n"));
    });
  };
  EXPECT_TRUE(refused("kind = 'integrator', input = 1", {"d:5", "'c.x'", "has states", "triggered"}));
  EXPECT_TRUE(refused("kind = 'memory', input = 1", {"d:5", "'c.x'", "events of its own", "triggered"}));
}

}  // namespace
}  // namespace tandem::engine
