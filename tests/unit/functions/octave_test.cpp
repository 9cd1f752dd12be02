// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#ifdef TANDEM_OCTAVE
#include "tandem/mbs/functions/octave.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "refusal.hpp"
#include "scratch.hpp"
#include "tandem/mbs/functions/function_model.hpp"
#include "tandem/mbs/trajectory.hpp"

namespace tandem::mbs {
namespace {

using test::refuses;
using test::Scratch;

/// A mass of 2 kg on a spring of 8 N/m along x, with these lines behind.
std::string oscillator(const std::string& lines = "") {
  return "function model = oscillator ()\n"
         "  model.variables = {\"x\"};\n"
         "  model.q = 1; model.v = 0;\n"
         "  model.mass = @() 2;\n"
         "  model.constraints = @(t, q) zeros (0, 1);\n"
         "  model.jacobian = @(t, q) zeros (0, 1);\n"
         "  model.constraint_accelerations = @(t, q, v) zeros (0, 1);\n"
         "  model.forces = @(t, q, v) -8 * q;\n" +
         lines + "end\n";
}

FunctionModel open(const Scratch& folder, const std::string& text, const OctaveSettings& settings = {}) {
  folder.write("oscillator.m", text);
  return FunctionModel(open_octave(folder.path() / "oscillator.m", settings));
}

/// Whether a run ends in that error.
testing::AssertionResult ends(ErrorCode code, const std::string& lines, const std::vector<std::string>& texts,
                              const OctaveSettings& settings = {}) {
  const Scratch folder;
  return refuses(code, texts, [&] {
    FunctionModel model = open(folder, oscillator(lines), settings);
    trajectory(model, model.initial(0.0), {}, 0.125, 2);
  });
}

/// x(t) = cos 2t; the trapezoidal rule turns by 2 atan(h) a step, exactly.
TEST(Octave, AnOscillatorSwingsAsTheTrapezoidalRuleSays) {
  const Scratch folder;
  FunctionModel model = open(folder, oscillator("  model.stiffness = @(t, q, v) 8;\n"
                                                "  model.energy = @(t, q, v) v^2 + 4 * q^2;\n"));
  const Trajectory all = trajectory(model, model.initial(0.0), {}, 0.125, 16);
  EXPECT_NEAR(all.q(16, 0), std::cos(16 * 2 * std::atan(0.125)), 1e-14);
  EXPECT_EQ(all.iterations, 32);  // the second finds that nothing is left
  const double q = 0.5, v = 3.0;
  EXPECT_EQ(model.energy(&q, &v), 10.0);
}

TEST(Octave, WithoutTheStiffnessNewtonTakesLonger) {
  const Scratch folder;
  FunctionModel model = open(folder, oscillator());
  const Trajectory all = trajectory(model, model.initial(0.0), {}, 0.125, 16);
  EXPECT_NEAR(all.q(16, 0), std::cos(16 * 2 * std::atan(0.125)), 1e-9);  // 16 steps of a tolerance of 1e-10
  EXPECT_GT(all.iterations, 32);
}

TEST(Octave, WhatAModelPrintsIsPassedOver) {
  const Scratch folder;
  FunctionModel model =
      open(folder, "% a comment\nfunction model = oscillator ()\n  printf (\"tandem is fine\");\n" +
                       oscillator("  model.forces = @(t, q, v) loud (q);\n").substr(32) +
                       "function f = loud (q)\n  q\n  f = -8 * q;\nend\n");
  EXPECT_NEAR(trajectory(model, model.initial(0.0), {}, 0.125, 1).q(1, 0), std::cos(2 * std::atan(0.125)),
              1e-10);
}

TEST(Octave, RefusesAFileThatItCannotUse) {
  const Scratch folder;
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'absent'", "there is no file", "absent.m"},
                      [&] { open_octave(folder.path() / "absent.m"); }));
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"'no_such_octave'", "can't be started"},
                      [&] { open(folder, oscillator(), {.command = "no_such_octave"}); }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"oscillator.m", "parse error"},
                      [&] { open(folder, "function model = oscillator ()\n  model = [1, 2;;\nend\n"); }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"gives a double; allowed is a struct"},
                      [&] { open(folder, "function model = oscillator ()\n  model = 3;\nend\n"); }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"deadline is 0 s; allowed is above 0"},
                      [&] { open(folder, oscillator(), {.deadline = 0.0}); }));
}

TEST(Octave, RefusesAStructThatLacksSomethingOrHasTooMuch) {
  constexpr auto wrong = ErrorCode::invalid_argument;
  EXPECT_TRUE(ends(wrong, "  model = rmfield (model, \"q\");\n", {"lacks the field 'q'"}));
  EXPECT_TRUE(ends(wrong, "  model = rmfield (model, \"jacobian\");\n", {"lacks the field 'jacobian'"}));
  EXPECT_TRUE(ends(wrong, "  model.stifness = 3;\n", {"stifness", "did you mean 'stiffness'"}));
  EXPECT_TRUE(ends(wrong, "  model.q = [1; 2];\n", {"q is 2 x 1; allowed is 1 x 1"}));
  EXPECT_TRUE(ends(wrong, "  model.variables = {};\n", {"variables names none"}));
  EXPECT_TRUE(ends(wrong, "  model.variables = \"x\";\n", {"variables", "cell array"}));
  EXPECT_TRUE(ends(wrong, "  model.units = {\"m\", \"m\"};\n", {"units has 2 texts; allowed is 1"}));
}

TEST(Octave, TellsOctavesOwnMessage) {
  constexpr auto wrong = ErrorCode::invalid_argument;
  EXPECT_TRUE(ends(wrong, "  model.forces = @(t, q, v) error (\"too far at %g m\", q);\n",
                   {"'oscillator'", "forces at t = 0 s", "too far at 1 m"}));
  EXPECT_TRUE(ends(wrong, "  model.forces = @(t, q, v) undefined_thing (q);\n", {"undefined_thing"}));
  EXPECT_TRUE(
      ends(wrong, "  model.forces = @(t, q, v) [q, 1];\n", {"forces at t = 0 s is 1 x 2; allowed is 1 x 1"}));
  EXPECT_TRUE(ends(wrong, "  model.forces = @(t, q, v) {q};\n", {"its value is a cell"}));
  EXPECT_TRUE(ends(wrong, "  model.forces = @(t, q, v) q * i;\n", {"complex"}));
  EXPECT_TRUE(
      ends(wrong, "  model.forces = 3;\n  model.mass = @() ones (1, 1, 2);\n", {"mass", "3 dimensions"}));
  EXPECT_TRUE(ends(ErrorCode::numerical, "  model.forces = @(t, q, v) q / (t < 0.2) - q * NaN ^ (t > 0.2);\n",
                   {"'oscillator'", "forces at t = 0.25 s", "nan at (1, 1)"}));
}

TEST(Octave, TellsThatItWasKilledOrDoesNotAnswer) {
  constexpr auto broken = ErrorCode::input_output;
  EXPECT_TRUE(ends(broken, "  model.forces = @(t, q, v) kill (getpid (), 9);\n",
                   {"forces at t = 0 s", "it has ended (signal 9)"}));
  EXPECT_TRUE(ends(broken, "  model.forces = @(t, q, v) exit (3);\n",
                   {"forces at t = 0 s", "it has ended (exit status 3)"}));
  EXPECT_TRUE(ends(broken, "  disp (\"a last word\");\n  model.forces = @(t, q, v) pause (60);\n",
                   {"forces at t = 0 s", "no answer within the deadline of 3 s", "a last word"},
                   {.deadline = 3.0}));
}

}  // namespace
}  // namespace tandem::mbs
#endif
