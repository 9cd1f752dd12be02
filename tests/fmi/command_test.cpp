// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "command.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "changed_fmu.hpp"

namespace tandem::test {
namespace {

const std::string fmus = TANDEM_FMUS;

/// Two masses, one of them an FMU that is Co-Simulation, the other Model Exchange; more of the scenario
/// behind.
std::string two_masses(const std::string& more = "") {
  return "[subsystems.one]\nsource = \"fmu:" + fmus + "/mass.fmu\"\n" + more +
         "parameters = { \"set.k\" = 4, \"set.m\" = 2, step = 0.02 }\n"
         "[subsystems.two]\nsource = \"fmu:" +
         fmus + "/mass.fmu?type=me&set.k=4&step=0.01\"\n" +
         "[[connections]]\nfrom = \"one.x\"\nto = \"two.u\"\nreconstruction = \"lagrange3\"\n"
         "[[connections]]\nfrom = \"two.x\"\nto = \"one.u\"\nreconstruction = \"lagrange3\"\n"
         "[span]\nstop = 1\n";
}

TEST(FmuCommand, RunsAScenario) {
  const Scratch folder;
  folder.write("s.toml", two_masses());
  const Said said = tandem(folder, {"--quiet", "run", "s.toml", "--output", "r"});
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_TRUE(contains(read_text(folder.path() / "r/results.csv"), "one.x,one.v,one.F,two.x"));
}

/// Of Model Exchange inputs are functions of time.
TEST(FmuCommand, ADegreeBeyondTheOrderOfHeldInputsIsNoted) {
  const Scratch folder;
  folder.write("s.toml", two_masses());
  const Said said = tandem(folder, {"validate", "s.toml"});
  EXPECT_EQ(said.status, 0) << said.err;
  const std::string all = said.out + said.err;
  EXPECT_TRUE(contains(all,
                       "connection from two.x is of degree 3, and 'one' holds its inputs over a step, which "
                       "is of order 2; degree 1 comes first"))
      << all;
  EXPECT_FALSE(contains(all, "'two' holds")) << all;
}

/// Names as they stand in the FMU.
TEST(FmuCommand, ParametersMayStandInTablesAndLists) {
  const Scratch folder;
  folder.write("s.toml", "[constants]\nstart = 3\n[subsystems.space]\nsource = \"fmu:" + fmus +
                             "/space3.fmu\"\nparameters.step = 0.01\nparameters.outputs = [\"x\"]\n"
                             "parameters.set = { A = [0, 1, -1, 0], x0 = [\"$start\", 0] }\n"
                             "inputs.u = 0\n[span]\nstop = 0.01\n");
  const Said said = tandem(folder, {"--quiet", "run", "s.toml", "--output", "r"});
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_TRUE(contains(read_text(folder.path() / "r/results.csv"),
                       "space.x[0],space.x[1],space.y[0],space.y[1]\n0,3,0,6,0\n"))
      << read_text(folder.path() / "r/results.csv");
  const Said twice =
      tandem(folder, {"validate", "s.toml", "--set", "subsystems.space.parameters.\"set.x0\"=1 2"});
  EXPECT_EQ(twice.status, 2);
  EXPECT_TRUE(contains(twice.err, "parameter 'set.x0' is given twice")) << twice.err;
  const Said wrong =
      tandem(folder, {"validate", "s.toml", "--set", "subsystems.space.parameters.outputs=[[1]]"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_TRUE(contains(wrong.err, "outputs")) << wrong.err;
}

/// One by one, each in a process of its own, or several in processes of their own.
TEST(FmuCommand, ThatMayBeThereOnceIsSweptAndChecked) {
  const Scratch folder;
  changed(folder, describing,
          description_with("<CoSimulation ", "<CoSimulation canBeInstantiatedOnlyOncePerProcess=\"true\" "));
  folder.write("s.toml", "[subsystems.a]\nsource = \"fmu:x.fmu\"\n[span]\nstop = 1\n");
  folder.write("study.toml",
               "scenario = \"s.toml\"\n[set]\n'subsystems.a.parameters.\"set.k\"' = \"$k\"\n"
               "[[tables.rows.blocks]]\naxes = [{ k = [1, 2, 3, 4, 5, 6, 7, 8] }]\n"
               "[metrics.size]\nof = \"a.x\"\nnorm = \"rms\"\n");
  const auto sweep = [&](const std::string& isolate, const std::string& to) {
    return tandem(folder, {"sweep", "study.toml", "--threads", "4", "--set",
                           "subsystems.a.isolate=" + isolate, "--output", to});
  };
  const Said together = sweep("false", "one"), apart = sweep("true", "several");
  EXPECT_TRUE(contains(together.out, "8 rows, 8 ok")) << together.out + together.err;
  EXPECT_TRUE(contains(together.err, "subsystem 'a' may be there once in a process")) << together.err;
  EXPECT_FALSE(contains(apart.err, "once")) << apart.err;
  EXPECT_EQ(read_text(folder.path() / "one/rows.csv"), read_text(folder.path() / "several/rows.csv"));
  const Said checked = tandem(folder, {"check", "fmu:x.fmu?type=cs"});
  EXPECT_TRUE(contains(checked.out, "checks, nothing wrong")) << checked.out + checked.err;
}

/// Inputs of whole numbers have no value between two.
TEST(FmuCommand, ACheckLeavesDiscreteInputsConstant) {
  const Scratch folder;
  for (const std::string name : {"types", "types3"}) {
    const Said checked = tandem(folder, {"check", "fmu:" TANDEM_FMUS "/" + name + ".fmu?step=0.1"});
    EXPECT_TRUE(contains(checked.out, "checks, nothing wrong")) << checked.out + checked.err;
    EXPECT_FALSE(contains(checked.err, "is rounded to")) << checked.err;
  }
}

TEST(FmuCommand, InAProcessOfItsOwnItHasTheSameResults) {
  const Scratch folder;
  folder.write("s.toml", two_masses()), folder.write("i.toml", two_masses("isolate = true\n"));
  ASSERT_EQ(tandem(folder, {"--quiet", "run", "s.toml", "--output", "s"}).status, 0);
  const Said said = tandem(folder, {"--quiet", "run", "i.toml", "--output", "i"});
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_EQ(read_text(folder.path() / "s/results.csv"), read_text(folder.path() / "i/results.csv"));
}

/// Without its code: the parameters of the way to that process are its own, and what stands against a run is told.
TEST(FmuCommand, InAProcessOfItsOwnItIsCheckedAsElsewhere) {
  const Scratch folder;
  folder.write("i.toml", two_masses("isolate = true\n"));
  const auto status = [&](const std::string& command, const std::string& setting) {
    return tandem(folder, {"--quiet", command, "i.toml", "--set", "subsystems.one.parameters." + setting})
        .status;
  };
  for (const char* command : {"validate", "info", "run"})
    EXPECT_EQ(status(command, "deadline=5"), 0) << command;
  EXPECT_EQ(status("validate", "deadlin=5"), 2);
  folder.write("t.toml", "[subsystems.one]\nsource = \"" + changed(folder, library, "a text") +
                             "\"\nisolate = true\n[span]\nstop = 1\n");
  const Said none = tandem(folder, {"validate", "t.toml"});
  EXPECT_EQ(none.status, 0) << none.err;
  EXPECT_TRUE(contains(none.out, "it can't be run here: the FMU has ")) << none.out;
  const Said run = tandem(folder, {"run", "t.toml"});
  EXPECT_EQ(run.status, 2);
  EXPECT_TRUE(contains(run.err, "which is no shared library for this processor")) << run.err;
}

/// This program has a CVODE, too, and it is loaded already.
TEST(FmuCommand, AnFmuUsesTheCvodeThatItBrings) {
  if (!std::filesystem::exists(fmus + "/cvode.fmu")) GTEST_SKIP() << "the archives of SUNDIALS are absent";
  const Scratch folder;
  folder.write("s.toml", "[subsystems.decay]\nsource = \"fmu:" + fmus +
                             "/cvode.fmu\"\n[subsystems.mass]\nsource = \"fmu:" + fmus +
                             "/mass.fmu\"\n[[connections]]\nfrom = \"decay.x\"\nto = \"mass.u\"\n"
                             "reconstruction = \"lagrange1\"\n[span]\nstop = 1\n");
  const Said said = tandem(folder, {"--quiet", "run", "s.toml", "--output", "r"});
  ASSERT_EQ(said.status, 0) << said.err;
  const std::string rows = read_text(folder.path() / "r/results.csv");
  const auto last = rows.rfind("\n1,");
  ASSERT_NE(last, std::string::npos);
  EXPECT_NEAR(std::stod(rows.substr(last + 3)), std::exp(-1.0), 1e-8);
}

TEST(FmuCommand, ValidateReadsItsPortsAndRunsNothing) {
  const Scratch folder;
  folder.write("s.toml", two_masses());
  const Said said = tandem(folder, {"validate", "s.toml"});
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_TRUE(contains(said.out, "subsystem 'one' is read and not run")) << said.out;
  EXPECT_EQ(tandem(folder, {"validate", "s.toml", "--run-programs"}).status, 0);
  std::string wrong = two_masses();
  wrong.replace(wrong.find("one.u"), 5, "one.w");
  folder.write("s.toml", wrong);
  const Said refused = tandem(folder, {"validate", "s.toml"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_TRUE(contains(refused.err, "s.toml:12: subsystem 'one': input 'w' is not there")) << refused.err;
}

TEST(FmuCommand, InfoTellsWhatTheDescriptionHas) {
  const Scratch folder;
  const Said said = tandem(folder, {"info", "fmu:" + fmus + "/mass.fmu"});
  EXPECT_EQ(said.status, 0) << said.err;
  for (const std::string text : {"FMI 2.0, Co-Simulation (it offers Model Exchange, too)", "set.d = 0 N s/m",
                                 "u  unit m, start value 0", "F at once from u", "own step: 0.01 s"})
    EXPECT_TRUE(contains(said.out, text)) << text << " in " << said.out;
}

/// A unit that is said on one side only fits, and is told.
TEST(FmuCommand, AUnitThatIsNotSaidIsTold) {
  const Scratch folder;
  folder.write("s.toml", "[subsystems.decay]\nsource = \"fmu:" + fmus +
                             "/decay.fmu\"\n[subsystems.mass]\nsource = \"fmu:" + fmus +
                             "/mass.fmu\"\n[[connections]]\nfrom = \"decay.x\"\nto = \"mass.u\"\n"
                             "reconstruction = \"lagrange1\"\n[span]\nstop = 1\n");
  const Said said = tandem(folder, {"validate", "s.toml"});
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_TRUE(
      contains(said.out, "from decay.x, whose unit is not said, to mass.u [m] takes values as they are"))
      << said.out;
}

TEST(FmuCommand, ARunOfModelExchangeGoesOnFromACheckpoint) {
  const Scratch folder;
  folder.write("s.toml", "[subsystems.ball]\nsource = \"fmu:" + fmus + "/ball.fmu\"\n[span]\nstop = 2\n");
  ASSERT_EQ(tandem(folder, {"--quiet", "run", "s.toml", "--output", "whole"}).status, 0);
  const Said said =
      tandem(folder, {"--quiet", "run", "s.toml", "--output", "cut", "--checkpoint-every", "0.5"});
  ASSERT_EQ(said.status, 0) << said.err;
  EXPECT_EQ(read_text(folder.path() / "whole/results.csv"), read_text(folder.path() / "cut/results.csv"));
}

}  // namespace
}  // namespace tandem::test
