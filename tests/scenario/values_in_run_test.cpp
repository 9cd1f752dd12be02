// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Expressions wherever a number may stand; tables where none may.
#include <gtest/gtest.h>

#include <cmath>

#include "scene_run.hpp"

namespace tandem::test {
namespace {

/// x = 2 + cos(sqrt(k) t) with k = 100 by [run], 400 by the command line.
TEST(ValuesInRun, AMechanismTakesExpressionsInRunAndView) {
  const Scratch folder;
  const auto file = folder.write(
      "m.toml",
      "dimension = 2\n[parameters]\nk = { value = 1, unit = 'N/m' }\nL = { value = 2, unit = 'm' }\n"
      "h = { value = 1e-3, unit = 's' }\nhow = { value = 'rk4', allowed = ['rk4', 'newmark'] }\n"
      "[coordinates]\nx = { unit = 'm', inertia = 1, at = '$(L+1)' }\n"
      "[springs]\ns = { coordinate = 'x', stiffness = '$k', free = '$L' }\n[outputs]\nx = { position = 'x' "
      "}\n"
      "[view]\nground = '$(L/2)'\n"
      "[run]\nformulation = 'null_space'\nintegrator = '$how'\nstep = '$(2*h)'\nstop = '$(500*h)'\nk = "
      "'$(50*L)'\n");
  const SceneRun own(file.string()), set(file.string(), {"run.k=$(200*L)"});
  ASSERT_EQ(own.said().status, 0) << own.said().err;
  EXPECT_EQ(own.times().back(), 0.5);
  EXPECT_NEAR(own.last("m.x"), 2.0 + std::cos(10.0 * 0.5), 1e-8);
  EXPECT_NEAR(set.last("m.x"), 2.0 + std::cos(20.0 * 0.5), 1e-6);
  for (const auto& [value, word] : {std::pair{"$(M*200)", "'M' is not there"}, {"{}", "run.k is a table"}}) {
    const Said said = tandem(folder, {"run", "m.toml", "--set", std::string("run.k=") + value});
    EXPECT_EQ(said.status, 2);
    EXPECT_TRUE(contains(said.err, word)) << said.err;
  }
}

/// Each stands for one value, whoever gives it: a reference to others, and one to itself.
TEST(ValuesInRun, AReferenceThatIsAParametersValueHoldsForTheOthers) {
  const Scratch folder;
  const auto file = folder.write(
      "m.toml",
      "dimension = 2\n[parameters]\nh = { value = 1e-3, unit = 's' }\nT = { value = 1, unit = 's' }\n"
      "J = { value = 0.5, unit = 's' }\n[coordinates]\nx = { unit = 'm', inertia = '$J' }\n"
      "[outputs]\nx = { position = 'x' }\n[run]\nstep = '$(2*h)'\nstop = '$T'\n");
  EXPECT_EQ(SceneRun(file.string(), {"run.h=$(T*5e-3)"}).times().size(), 101U);
  EXPECT_EQ(SceneRun(file.string(), {"run.T=$J"}).times().back(), 0.5);
  EXPECT_EQ(SceneRun(file.string(), {"run.h=$(5*h)"}).times().size(), 101U);
  ASSERT_EQ(tandem(folder, {"run", "m.toml", "--output", "o", "--set", "run.J=$T"}).status, 0);
  const Said view = tandem(folder, {"view", "o"});
  EXPECT_EQ(view.status, 0) << view.err;
}

/// x' = (u - x)/k, u = k = 3: 3 (1 - exp(-t/3)).
TEST(ValuesInRun, ADiagramTakesThemForInputsAndTolerances) {
  const Scratch folder;
  const auto file =
      folder.write("d.toml",
                   "[parameters]\nk = { value = 3, unit = '1' }\n[inputs]\nu = { unit = '1' }\n"
                   "[blocks]\nx = { kind = 'lag', input = 'u', time = '$k' }\n[outputs]\nx = { unit = '1' }\n"
                   "[run]\nstop = '$(k/3)'\nstep = 0.01\ninputs = { u = '$k' }\nintegrator = 'cvode_adams'\n"
                   "relative_tolerance = '$(k/3e9)'\nabsolute_tolerance.x = 1e-9\n");
  const SceneRun run(file.string());
  ASSERT_EQ(run.said().status, 0) << run.said().err;
  EXPECT_NEAR(run.last("d.x"), 3.0 * (1.0 - std::exp(-1.0 / 3.0)), 1e-7);
}

TEST(ValuesInRun, ATableIsNoValueOfABlock) {
  for (const char* block :
       {"kind = 'gain', input = 3, gain = 2, offset = { a = 1 }",
        "kind = 'lag', input = 1, time = 1, initial = {}", "kind = 'pid', input = 1, kp = 1, low = {}",
        "kind = 'relay', input = 1, low = 0, high = 1, starts_on = {}",
        "kind = 'table', input = 1, x = [0, 1], y = [0, 1], beyond = {}"}) {
    const Scratch folder;
    folder.write("d.toml", std::string("[blocks]\nb = { ") + block + " }\n[outputs]\nb = { unit = '1' }\n");
    const Said said = tandem(folder, {"info", "d.toml"});
    EXPECT_EQ(said.status, 2) << block;
    EXPECT_TRUE(contains(said.err, " is a table; allowed is ")) << said.err;
  }
}

/// One name, two numbers: an expression has them already.
TEST(ValuesInRun, NamesThatExpressionsHaveAreRefused) {
  for (const char* name : {"_pi", "_e"}) {
    const Scratch folder;
    folder.write("d.toml",
                 std::string("[parameters]\n") + name +
                     " = { value = 2, unit = '1' }\n[blocks]\nb = { kind = 'constant', value = 1 }\n"
                     "[outputs]\nb = { unit = '1' }\n");
    folder.write("s.toml", std::string("[constants]\n") + name +
                               " = 2\n[subsystems.a]\nsource = 'diagram:d.toml'\nparameters = { step = '$" +
                               name + "' }\n[span]\nstop = 9\n");
    for (const char* words : {"info", "validate"}) {
      const Said said = tandem(folder, {words, words == std::string("info") ? "d.toml" : "s.toml"});
      EXPECT_EQ(said.status, 2) << name;
      EXPECT_TRUE(contains(said.err, "has a name that expressions have already")) << said.err;
    }
  }
}

/// Without a point or a body: two inertias on a shaft, driven by a couple from rest. Their mean speed grows by
/// M t / (J1 + J2), the twist is M J2 / (c (J1 + J2)) (1 - cos(w t)), w^2 = c (1/J1 + 1/J2).
TEST(ValuesInRun, AMechanismNeedsNoBodies) {
  const Scratch folder;
  const auto file = folder.write(
      "m.toml",
      "dimension = 2\n[coordinates]\na = { unit = 'rad', inertia = 0.05 }\nb = { unit = 'rad', inertia = 0.2 "
      "}\n"
      "twist = { unit = 'rad' }\n[relations]\ntwist = { terms = { a = 1, b = -1, twist = -1 } }\n"
      "[springs]\nshaft = { coordinate = 'twist', stiffness = 2400 }\n[inputs]\nM = { unit = 'N m', value = "
      "10 }\n"
      "[forces]\nM = { coordinate = 'a', magnitude = 'M' }\n"
      "[outputs]\na = { velocity = 'a' }\nb = { velocity = 'b' }\ntwist = { position = 'twist' }\n"
      "[run]\nstop = 0.1\nstep = 1e-4\n");
  const double w = std::sqrt(2400.0 * (1.0 / 0.05 + 1.0 / 0.2));
  for (const char* how : {"null_space", "index1", "index3", "penalty"}) {
    const SceneRun run(file.string(), {std::string("run.formulation=") + how});
    ASSERT_EQ(run.said().status, 0) << run.said().err;
    EXPECT_NEAR((0.05 * run.last("m.a") + 0.2 * run.last("m.b")) / 0.25, 10.0 * 0.1 / 0.25, 1e-6) << how;
    EXPECT_NEAR(run.last("m.twist"), 10.0 * 0.2 / (2400.0 * 0.25) * (1.0 - std::cos(w * 0.1)), 1e-5) << how;
  }
  folder.write("light.toml",
               "dimension = 2\n[coordinates]\na = { unit = 'rad' }\n[outputs]\na = { position = 'a' }\n");
  const Said said = tandem(folder, {"info", "light.toml"});
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said.err, "or [coordinates.NAME] with inertia")) << said.err;
}

/// In one way from the command line, the table [run], a scenario and a URI.
TEST(ModesCommand, TakesParametersAsARunDoes) {
  const Scratch folder;
  const std::string m =
      "dimension = 2\n[parameters]\nk = { value = 39.4784176, unit = 'N/m' }\n"
      "[coordinates]\nx = { unit = 'm', inertia = 1 }\n[springs]\ns = { coordinate = 'x', stiffness = '$k' "
      "}\n"
      "[outputs]\nx = { position = 'x' }\n[run]\nstep = 1e-3\n";
  folder.write("m.toml", m);
  folder.write("stiff.toml", m + "k = '$(4*39.4784176)'\n");
  EXPECT_TRUE(contains(tandem(folder, {"modes", "m.toml"}).out, "1.000 Hz"));
  EXPECT_TRUE(contains(tandem(folder, {"modes", "m.toml", "--set", "run.k=157.91367"}).out, "2.000 Hz"));
  EXPECT_TRUE(contains(tandem(folder, {"modes", "stiff.toml"}).out, "2.000 Hz"));
  folder.write("s.toml", "[subsystems.a]\nsource = 'mechanism:m.toml?k=157.91367'\n[span]\nstop = 1\n");
  EXPECT_TRUE(contains(tandem(folder, {"modes", "s.toml"}).out, "2.000 Hz"));
  for (const auto& [what, set, word] :
       {std::tuple{"m.toml", "run.kk=1", "'kk' is not there; did you mean 'k'?"},
        {"m.toml", "run.k=abc", "'k' is 'abc'"},
        {"s.toml", "subsystems.a.parameters.kk=1", "'kk' is not there"},
        {"s.toml", "subsystems.a.parameters.formulation=abc", "formulation 'abc'"}}) {
    const Said said = tandem(folder, {"modes", what, "--set", set});
    EXPECT_EQ(said.status, 2) << said.out;
    EXPECT_TRUE(contains(said.err, word)) << said.err;
  }
}

TEST(ValuesInRun, AreOfParametersThatHaveNoNameOfASetting) {
  const Scratch folder;
  const auto says = [&](const std::string& name, const std::string& rest) {
    folder.write("s.toml", "[parameters]\n" + name + " = { value = 1, unit = 's' }\n" + rest);
    const Said said = tandem(folder, {"info", "s.toml"});
    EXPECT_EQ(said.status, 2) << said.out;
    EXPECT_TRUE(contains(said.err, "parameter '" + name + "' has the name of a setting")) << said.err;
  };
  for (const char* name : {"start", "stop", "inputs", "step", "beta"})
    says(name, "[coordinates]\nx = { unit = 'm', inertia = 1 }\n[run]\nstep = 1e-3\nstop = 1\n");
  for (const char* name : {"start", "stop", "inputs", "step", "integrator"})
    says(name, "[blocks]\nc = { kind = 'constant', value = 1 }\n[run]\nstep = 1e-3\nstop = 1\n");
}

TEST(InfoCommand, RefusesWhatARunOfADiagramWould) {
  const Scratch folder;
  const std::string d =
      "[blocks]\nc = { kind = 'constant', value = 1 }\n[outputs]\nc = { unit = '1' }\n[run]\n";
  for (const auto& [run, word] : {std::pair{"step = 'a'\n", "'step' is 'a'"},
                                  {"step = 1\ncolour = 2\n", "'colour' is not there"},
                                  {"step = 1\nstop = 2\ninputs = { v = 1 }\n", "input 'v' is not there"}}) {
    folder.write("d.toml", d + run);
    const Said said = tandem(folder, {"info", "d.toml"});
    EXPECT_EQ(said.status, 2) << said.out;
    EXPECT_TRUE(contains(said.err, word)) << said.err;
  }
}

}  // namespace
}  // namespace tandem::test
