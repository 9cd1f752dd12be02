// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Diagrams from the command line.
#include <gtest/gtest.h>

#include <algorithm>

#include "command.hpp"

namespace tandem {
namespace {

using test::contains;
using test::Said;
using test::Scratch;
using test::tandem;

const std::string engine = TANDEM_SOURCE_DIR "/scenarios/engine/engine.toml";

TEST(InfoCommand, ShowsWhatADiagramHas) {
  const Scratch folder;
  const Said said = tandem(folder, {"info", engine});
  EXPECT_EQ(said.status, 0) << said.err;
  for (const char* part :
       {"order 4: manifold.P, charges.angle, charges.M, crank.N", "parameter J = 0.14 kg m^2",
        "input throttle [deg]", "output torque [N m], follows at once: none; events may make it jump\n",
        "parameter stall = 'stop'", "16 signals watched for events"})
    EXPECT_TRUE(contains(said.out, part)) << part << " is not in:\n" << said.out;
}

TEST(InfoCommand, DrawsTheGraphOfADiagram) {
  const Scratch folder;
  const Said said = tandem(folder, {"info", engine, "--dot"});
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_TRUE(contains(said.out, "digraph \"engine\" {")) << said.out;
  for (const char* part :
       {"subgraph \"cluster manifold\" {", "\"throttle\" -> \"manifold.opening\" [label=\"input\"];",
        "\"charges.burnt\" -> \"crank.torque.torque\"", "\"crank.N\" -> \"limit crank.stall\""})
    EXPECT_TRUE(contains(said.out, part)) << part << " is not in:\n" << said.out;
  EXPECT_EQ(tandem(folder, {"info", test::two_mass_file("two_mass.toml"), "--dot"}).status, 2);
}

TEST(InfoCommand, DrawsWhatGraphvizReads) {
  if (std::system("dot -V 2>/dev/null") != 0) GTEST_SKIP() << "Graphviz is absent";
  const Scratch folder;
  folder.write("g.dot", tandem(folder, {"info", engine, "--dot"}).out);
  const std::string file = (folder.path() / "g").string();
  ASSERT_EQ(
      std::system(("dot -Tplain '" + file + ".dot' > '" + file + ".txt' 2> '" + file + ".err'").c_str()), 0);
  EXPECT_EQ(test::read_text(file + ".err"), "");
  EXPECT_TRUE(contains(test::read_text(file + ".txt"), "node \"charges.burnt\""));
}

TEST(InfoCommand, DrawsWhatIsLeftOutAndWhatIsRefused) {
  const Scratch folder;
  folder.write("d.toml",
               "[blocks]\nx = { kind = 'gain', input = 'time', gain = 2 }\n"
               "idle = { kind = 'gain', input = 'x', gain = 3 }\n[outputs]\nx = { unit = '1' }\n");
  const Said dead = tandem(folder, {"info", "d.toml", "--dot"});
  EXPECT_EQ(dead.status, 0) << dead.err;
  EXPECT_TRUE(contains(dead.out, "\"idle\" [label=\"idle\\ngain\", style=dashed];")) << dead.out;
  folder.write("d.toml",
               "[blocks]\nx = { kind = 'gain', input = 'y', gain = 2 }\n"
               "y = { kind = 'gain', input = 'x', gain = 3 }\n[outputs]\nx = { unit = '1' }\n");
  const Said loop = tandem(folder, {"info", "d.toml", "--dot"});
  EXPECT_EQ(loop.status, 2);
  EXPECT_TRUE(contains(loop.err, "algebraic loop")) << loop.err;
  EXPECT_TRUE(contains(loop.out, "\"y\" -> \"x\"")) << loop.out;
}

/// A scenario of one diagram and its parameters.
Said run(const Scratch& folder, const std::string& blocks, const std::string& parameters) {
  folder.write("d.toml", "[parameters]\nk = { value = 2, unit = '1' }\n[blocks]\n" + blocks +
                             "\n[outputs]\nx = { unit = '1' }\n");
  folder.write("s.toml", "name = 's'\n[subsystems.d]\nsource = 'diagram:d.toml'\nparameters = { " +
                             parameters + " }\n[span]\nstop = 1.0\n");
  return tandem(folder, {"run", "s.toml", "--output", "o"});
}

TEST(RunCommand, RunsADiagramWithItsParameters) {
  const Scratch folder;
  const std::string decay =
      "x = { kind = 'integrator', input = 'rate', initial = 1 }\nrate = { kind = 'product', inputs = ['x', "
      "'$k'] }";
  for (const char* integrator : {"rk4", "cvode_adams", "cvode_bdf", "erkstep", "arkstep"}) {
    const Said said =
        run(folder, decay, "step = 0.01, k = -1, integrator = '" + std::string(integrator) + "'");
    EXPECT_EQ(said.status, 0) << said.err;
    const std::string results = test::read_text(folder.path() / "o" / "results.csv");
    EXPECT_TRUE(contains(results, "\n1,0.3678")) << integrator << ": " << results.substr(results.size() - 40);
  }
}

TEST(RunCommand, RefusesWhatADiagramCanNotDo) {
  const Scratch folder;
  const std::string fine = "x = { kind = 'integrator', input = 1 }";
  const struct {
    std::string blocks, parameters, words;
    int status;
  } list[] = {
      {fine, "k = 1", "has no own step: step is 0 s", 2},
      {fine, "step = -1", "step is -1 s; allowed is a finite number above 0", 2},
      {fine, "step = 0.1, j = 1", "'j'", 2},
      {fine, "step = 0.1, integrator = 'rk5'", "'rk5' is not there; did you mean 'rk4'", 2},
      {fine, "step = 0.1, relative_tolerance = 1e-3", "rk4 is chosen", 2},
      {fine, "step = 0.1, 'absolute_tolerance.x' = 1e-3", "rk4 is chosen", 2},
      {fine, "step = 0.1, integrator = 'erkstep', 'absolute_tolerance.y' = 1e-3", "state 'y' is not there",
       2},
      {"x = { kind = 'gain', input = 'x', gain = 1 }", "step = 0.1", "algebraic loop", 2},
      {"x = { kind = 'gain', input = 'y', gain = 1 }", "step = 0.1",
       "d.toml:4: block 'x': signal 'y' is not there", 2},
      {"x = { kind = 'integrator', input = 'r' }\nr = { kind = 'function', function = 'log', input = 'x' }",
       "step = 0.1", "subsystem 'd', initialize: it gave x (a derivative) not finite at t = 0 s", 2},
      {"x = { kind = 'integrator', input = 'r', initial = 1 }\nr = { kind = 'product', inputs = ['x', 'x', "
       "'x'] }",
       "step = 0.01, integrator = 'cvode_bdf'", "integrator cvode_bdf no longer comes forward at t = 0.49998",
       1}};
  for (const auto& bad : list) {
    const Said said = run(folder, bad.blocks, bad.parameters);
    EXPECT_EQ(said.status, bad.status) << bad.parameters << ": " << said.err;
    EXPECT_TRUE(contains(said.err, bad.words)) << bad.words << " is not in: " << said.err;
  }
}

const std::string lagging =
    "[parameters]\nT = { value = 0.5, unit = 's' }\n[inputs]\nu = { unit = '1' }\n[blocks]\n"
    "x = { kind = 'integrator', input = 'r' }\nd = { kind = 'sum', inputs = ['u', 'x'], gains = [1, -1] }\n"
    "r = { kind = 'quotient', numerator = 'd', denominator = '$T' }\n[outputs]\nx = { unit = '1' }\n[run]\n"
    "stop = 1.0\nstep = 0.01\n";

/// x = 3 (1 - exp(-t / T)); on a ramp t: t - T (1 - exp(-t / T)).
TEST(RunCommand, RunsADiagramAlone) {
  const Scratch folder;
  folder.write("d.toml", lagging + "inputs = { u = 3.0 }\n");
  ASSERT_EQ(tandem(folder, {"run", "d.toml", "--output", "o"}).status, 0);
  EXPECT_TRUE(contains(test::read_text(folder.path() / "o" / "results.csv"), "\n1,2.59399"));
  ASSERT_EQ(tandem(folder, {"run", "d.toml", "--set", "run.T=1", "--output", "o"}).status, 0);
  EXPECT_TRUE(contains(test::read_text(folder.path() / "o" / "results.csv"), "\n1,1.89636"));
  ASSERT_EQ(tandem(folder, {"run", "d.toml", "--set", "blocks.d.gains=[2, -1]", "--output", "o"}).status, 0);
  EXPECT_TRUE(contains(test::read_text(folder.path() / "o" / "results.csv"), "\n1,5.18798"));
  const Said wrong = tandem(folder, {"run", "d.toml", "--set", "blocks.d.kind=som"});
  EXPECT_TRUE(contains(wrong.err, "d.toml: --set blocks.d.kind=som: block 'd': kind 'som' is not there"))
      << wrong.err;
  ASSERT_EQ(tandem(folder, {"run", "d.toml", "--set", "run.T=1", "--output", "o"}).status, 0);
  const std::string figures = test::read_text(folder.path() / "o" / "machine.json");
  EXPECT_TRUE(contains(figures, "\"rate_evaluations\": 400")) << figures;
  folder.write("ramp.csv", "time,u,w\n0,0,0\n1,1,2\n");
  folder.write("e.toml", lagging + "inputs.u = { file = 'ramp.csv', column = 'w' }\n");
  ASSERT_EQ(tandem(folder, {"run", "e.toml", "--output", "o"}).status, 0);
  EXPECT_TRUE(contains(test::read_text(folder.path() / "o" / "results.csv"), "\n1,1.13533"));
}

TEST(RunCommand, RefusesToRunADiagramAloneWithoutWhatItTakes) {
  const Scratch folder;
  folder.write("d.toml", lagging);
  EXPECT_TRUE(contains(tandem(folder, {"run", "d.toml"}).err, "d.u"));
  folder.write("d.toml", lagging + "inputs = { w = 1 }\n");
  EXPECT_TRUE(contains(tandem(folder, {"run", "d.toml"}).err, "d.toml:14"))
      << tandem(folder, {"run", "d.toml"}).err;
  folder.write("d.toml", lagging + "inputs.u = { file = 'none.csv', column = 'u' }\n");
  EXPECT_TRUE(contains(tandem(folder, {"run", "d.toml"}).err, "none.csv"));
  EXPECT_EQ(tandem(folder, {"run", "d.toml", "--set", "blocks.x.input=y"}).status, 2);
}

/// What SUNDIALS says goes into the one sentence of the error.
TEST(RunCommand, MessagesOfSundialsComeWithTheSubsystemsNameAndNeverAlone) {
  const Scratch folder;
  for (const char* integrator : {"cvode_adams", "cvode_bdf", "erkstep", "arkstep"}) {
    const Said said = run(folder,
                          "x = { kind = 'integrator', input = 'r', initial = 1 }\n"
                          "r = { kind = 'product', inputs = ['x', 'x', 'x'] }",
                          "step = 0.01, integrator = '" + std::string(integrator) + "'");
    EXPECT_EQ(said.status, 1);
    EXPECT_EQ(std::count(said.err.begin(), said.err.end(), '\n'), 1) << said.err;
    EXPECT_TRUE(contains(said.err, "subsystem 'd', advance at t = ")) << said.err;
  }
}

}  // namespace
}  // namespace tandem
