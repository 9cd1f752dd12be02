// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// State machines: thresholds, dwell, lock-out, outputs by state.
#include <gtest/gtest.h>

#include <sstream>

#include "diagram_run.hpp"
#include "refusal.hpp"

namespace tandem::engine {
namespace {

using test::DiagramRun;
using test::refuses;

const std::string outputs =
    "[outputs]\ngear = { unit = '1' }\nratio = { unit = '1', from = 'gear.ratio' }\n"
    "before = { unit = '1', from = 'gear.ratio_before' }\nentered = { unit = 's', from = 'gear.entered' }\n";

/// Up above 1 and above 1.05, down below a threshold that is a signal.
const std::string gears =
    "[blocks]\nlow = { kind = 'gain', input = 'time', gain = 0.5, offset = 1 }\n"
    "[blocks.gear]\nkind = 'machine'\nstates = ['first', 'second', 'third']\nlockout = 0.3\nentered = -9\n"
    "outputs = { ratio = [2.4, 1.4, 1.0] }\n"
    "[[blocks.gear.transitions]]\nfrom = 'first'\nto = 'second'\ninput = 'time'\nabove = 1\ndwell = 0.1\n"
    "[[blocks.gear.transitions]]\nfrom = 'second'\nto = 'third'\ninput = 'time'\nabove = 1.05\ndwell = 0.1\n"
    "[[blocks.gear.transitions]]\nfrom = 'third'\nto = 'first'\ninput = 1.9\nbelow = 'low'\ndwell = 0.05\n" +
    outputs;

/// 1.1: dwelt since 1. 1.5: locked out up to 1.4, and dwelt since. The threshold passes 1.9 at 1.8.
TEST(Machine, DwellsAndIsLockedOut) {
  const struct {
    double t, gear, ratio, before, entered;
  } list[] = {{1.09, 1, 2.4, 2.4, -9},  {1.11, 2, 1.4, 2.4, 1.1}, {1.49, 2, 1.4, 2.4, 1.1},
              {1.51, 3, 1.0, 1.4, 1.5}, {1.84, 3, 1.0, 1.4, 1.5}, {1.86, 1, 2.4, 1.0, 1.85}};
  for (const auto& at : list) {
    DiagramRun run(gears);
    run.run(at.t, 17);
    EXPECT_EQ(run.simulation.output(0), at.gear) << at.t;
    EXPECT_EQ(run.simulation.output(1), at.ratio) << at.t;
    EXPECT_EQ(run.simulation.output(2), at.before) << at.t;
    EXPECT_NEAR(run.simulation.output(3), at.entered, 1e-12) << at.t;
  }
}

std::string two_states(const std::string& transitions) {
  return "[blocks]\nx = { kind = 'sine', amplitude = 1, frequency = 1 }\n[blocks.gear]\nkind = 'machine'\n"
         "states = ['a', 'b', 'c']\noutputs = { ratio = [10, 20, 30] }\ntransitions = [" +
         transitions + "]\n" + outputs;
}

/// The condition holds for less than it has to.
TEST(Machine, ForgetsAConditionThatEnds) {
  DiagramRun run(two_states("{ from = 'a', to = 'b', input = 'x', above = 0.5, dwell = 0.4 }"));
  run.run(3.3, 33);
  EXPECT_EQ(run.simulation.output(0), 1.0);
}

TEST(Machine, TakesTheFirstInTheFileOfTwoAtOnce) {
  DiagramRun run(
      two_states("{ from = 'a', to = 'b', input = 'x', above = 0.5 }, { from = 'a', to = 'c', input = 'x', "
                 "above = 0.5 }"));
  run.run(0.2, 2);
  EXPECT_EQ(run.simulation.output(1), 20.0);
  EXPECT_NEAR(run.simulation.output(3), 1.0 / 12.0, 1e-12);
}

/// And goes on at once where the next condition holds already.
TEST(Machine, SeesConditionsAtTheStart) {
  DiagramRun run(
      two_states("{ from = 'a', to = 'b', input = 'x', below = 0.5 }, { from = 'b', to = 'c', input = "
                 "'x', below = 0.5, dwell = 0.03 }"));
  run.run(0.02, 2);
  EXPECT_EQ(run.simulation.output(1), 20.0);
  run.simulation.run(0.04);
  EXPECT_EQ(run.simulation.output(1), 30.0);
  EXPECT_NEAR(run.simulation.output(3), 0.03, 1e-12);
}

TEST(Machine, IsRefusedByPlace) {
  const auto refused = [](const std::string& transitions, const std::vector<std::string>& words) {
    return refuses(ErrorCode::invalid_argument, words,
                   [&] { compile(read_diagram("d", two_states(transitions))); });
  };
  EXPECT_TRUE(refused("", {"d:7", "'gear' of kind machine", "transitions"}));
  EXPECT_TRUE(refused("{ from = 'a', to = 'z', input = 'x', above = 1 }",
                      {"d:7", "'gear.transitions[0]'", "to is 'z'", "a, b, c"}));
  EXPECT_TRUE(refused("{ from = 'a', to = 'b', input = 'x' }", {"d:7", "above and below"}));
  EXPECT_TRUE(
      refused("{ from = 'a', to = 'b', input = 'x', above = 1, dwell = -1 }", {"d:7", "dwell is -1"}));
  EXPECT_TRUE(refused("{ from = 'a', to = 'b', input = 'x', above = 1, until = 1 }", {"d:7", "'until'"}));
}

/// A gearbox of three gears with these ratios and thresholds, up from the first and the second, back from the
/// second and the third.
std::string gearbox(const std::string& ratios, const std::string& thresholds,
                    const std::string& of = "ratio") {
  std::istringstream in(thresholds);
  std::string up12, up23, down21, down32;
  in >> up12 >> up23 >> down21 >> down32;
  return "[inputs]\nv = { unit = 'm/s' }\n[blocks.low]\nkind = 'table'\ninput = 'time'\nx = [0, 1]\ny = [5, "
         "7]\n"
         "[blocks.gear]\nkind = 'machine'\nstates = ['first', 'second', 'third']\noutputs = { ratio = [" +
         ratios + "] }\ngears = '" + of +
         "'\ntransitions = [\n{ from = 'first', to = 'second', input = 'v', above = " + up12 +
         " },\n{ from = 'second', to = 'third', input = 'v', above = " + up23 +
         " },\n{ from = 'second', to = 'first', input = 'v', below = " + down21 +
         " },\n{ from = 'third', to = 'second', input = 'v', below = " + down32 + " } ]\n" + outputs;
}

TEST(Machine, OfGearsRefusesRatiosOutOfOrderOrNotAboveZero) {
  const auto refused = [](const std::string& ratios, const std::vector<std::string>& words) {
    return refuses(ErrorCode::invalid_argument, words,
                   [&] { compile(read_diagram("d", gearbox(ratios, "4 6 2 4"))); });
  };
  EXPECT_NO_THROW(compile(read_diagram("d", gearbox("2.4, 1.4, 1", "4 6 2 4"))));
  EXPECT_TRUE(refused("1.4, 2.4, 1", {"d:11", "'gear.outputs", "ratio is 2.4 in 'second'",
                                      "allowed is a number above 0 and below 1.4, that of 'first'"}));
  EXPECT_TRUE(refused("2.4, 1.4, 1.4", {"d:11", "ratio is 1.4 in 'third'", "below 1.4, that of 'second'"}));
  EXPECT_TRUE(refused("2.4, 1.4, -1", {"d:11", "ratio is -1 in 'third'", "a number above 0"}));
  EXPECT_TRUE(refused("0, -1, -2", {"d:11", "ratio is 0 in 'first'; allowed is a number above 0"}));
}

TEST(Machine, OfGearsRefusesThresholdsOutOfOrder) {
  const auto refused = [](const std::string& thresholds, const std::vector<std::string>& words) {
    return refuses(ErrorCode::invalid_argument, words,
                   [&] { compile(read_diagram("d", gearbox("2.4, 1.4, 1", thresholds))); });
  };
  EXPECT_TRUE(
      refused("6 5 2 4", {"d:15", "'gear' of kind machine", "the threshold from 'second' to 'third' is 5",
                          "allowed is above 6, the threshold from 'first' to 'second'"}));
  EXPECT_TRUE(refused("5 6 4 3", {"d:17", "the threshold from 'third' to 'second' is 3",
                                  "allowed is above 4, the threshold from 'second' to 'first'"}));
  EXPECT_TRUE(refused("'low' 6 2 4", {"d:15", "is 6 at 1 of their tables", "above 7"}));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument,
                      {"d:12", "gears is 'ration'", "the name of one of the outputs"},
                      [] { compile(read_diagram("d", gearbox("2, 1.5, 1", "4 6 2 4", "ration"))); }));
}

}  // namespace
}  // namespace tandem::engine
