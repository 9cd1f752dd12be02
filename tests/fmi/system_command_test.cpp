// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Commands with a system of SSP where a scenario may stand.
#include <gtest/gtest.h>

#include <array>
#include <filesystem>

#include "command.hpp"
#include "system_file.hpp"

namespace tandem::test {
namespace {

std::string coupled(const std::string& attributes) {
  return "<ssd:Annotations><ssc:Annotation type=\"org.tandem.coordination\"><t:x " + attributes +
         "/></ssc:Annotation></ssd:Annotations>";
}

/// Two masses, which the scenario beside couples alike.
const std::string coupled_masses =
    ssd("<ssd:Elements>" +
            component("one", "mass", bindings({{"k", "4"}, {"m", "2"}}) + coupled("step=\"0.02\"")) +
            component("two", "mass", bindings({{"k", "4"}}) + coupled("step=\"0.01\" type=\"me\"")) +
            "</ssd:Elements><ssd:Connections>" + ssd_connection("one.x", "two.u") +
            ssd_connection("two.x", "one.u", linear("1.5", "0.25")) + "</ssd:Connections>",
        coupled("reconstruction=\"lagrange3\""));

const std::string scenario_beside =
    "[subsystems.one]\nsource = \"fmu:" TANDEM_FMUS
    "/mass.fmu?set.k=4&set.m=2&step=0.02\"\n"
    "[subsystems.two]\nsource = \"fmu:" TANDEM_FMUS
    "/mass.fmu?set.k=4&step=0.01&type=me\"\n"
    "[[connections]]\nfrom = \"one.x\"\nto = \"two.u\"\nreconstruction = \"lagrange3\"\n"
    "[[connections]]\nfrom = \"two.x\"\nto = \"one.u\"\nreconstruction = \"lagrange3\"\n"
    "gain = 1.5\noffset = 0.25\n[span]\nstop = 1\n";

TEST(SystemCommand, RunsWithTheBitsOfTheScenario) {
  const Scratch folder;
  write_system(folder, coupled_masses);
  folder.write("t.toml", scenario_beside);
  const Said said = tandem(folder, {"--quiet", "run", "s.ssp", "--output", "s"});
  ASSERT_EQ(said.status, 0) << said.err;
  ASSERT_EQ(tandem(folder, {"--quiet", "run", "t.toml", "--output", "t"}).status, 0);
  EXPECT_EQ(read_text(folder.path() / "s/results.csv"), read_text(folder.path() / "t/results.csv"));
}

TEST(SystemCommand, GoesOnFromACheckpoint) {
  const Scratch folder;
  write_system(folder, coupled_masses);
  const auto run = [&](std::vector<std::string> words) {
    std::vector<std::string> all = {"--quiet", "run", "s.ssp", "--set", "parameters.type=me"};
    all.insert(all.end(), words.begin(), words.end());
    const Said said = tandem(folder, all);
    EXPECT_EQ(said.status, 0) << said.err;
  };
  run({"--output", "whole"});
  run({"--output", "part", "--checkpoint-every", "0.3"});
  const auto results = folder.path() / "part/results.csv";
  std::filesystem::resize_file(results, read_text(results).rfind("0.96,"));  // behind the checkpoint at 0.9 s
  run({"--output", "part", "--resume", "part/checkpoint"});
  EXPECT_EQ(read_text(folder.path() / "part/results.csv"), read_text(folder.path() / "whole/results.csv"));
}

TEST(SystemCommand, StandsWhereAScenarioMay) {
  const Scratch folder;
  write_system(folder, coupled_masses);
  folder.write("study.toml",
               "scenario = \"s.ssp\"\ncolumns = [\"step\"]\n[set]\n"
               "\"subsystems.one.parameters.step\" = \"$step\"\n[[tables.s.blocks]]\n"
               "axes = [{ step = [0.02, 0.01] }]\n[references.fine]\nwith = { step = 0.005 }\n"
               "[metrics]\nx = { of = \"one.x\", norm = \"max\", relative = \"peak\" }\n");
  folder.write("ladder.toml", scenario_beside +
                                  "[ladder]\n[[ladder.judged]]\nquantity = \"one.x\"\ntolerance = 0.1\n"
                                  "[[ladder.rungs]]\nname = \"a\"\nfile = \"s.ssp\"\n"
                                  "[[ladder.rungs]]\nname = \"b\"\n");
  for (const std::vector<std::string>& words : {std::vector<std::string>{"validate", "s.ssp"},
                                                {"info", "s.ssp"},
                                                {"info", "s.ssp", "--run-programs"},
                                                {"sweep", "s.ssp", "--output", "standing"},
                                                {"sweep", "study.toml", "--output", "study"},
                                                {"ladder", "ladder.toml", "--output", "ladder"},
                                                {"advise", "s.ssp"},
                                                {"stability", "s.ssp"},
                                                {"run", "s.ssp", "--dry-run"}}) {
    const Said said = tandem(folder, words);
    EXPECT_EQ(said.status, 0) << words[0] << ": " << said.err << said.out;
  }
}

TEST(SystemCommand, ErrorsNameTheLineOfTheSystem) {
  const Scratch folder;
  write_system(folder, coupled_masses);
  const Said said = tandem(folder, {"validate", "s.ssp", "--set", "subsystems.two.parameters.stp=1"});
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said.err, "stp")) << said.err;
  const std::string wrong =
      ssd("<ssd:Elements>\n" + component("one", "mass", coupled("stpe=\"1\"")) + "</ssd:Elements>");
  write_system(folder, wrong);
  const Said named = tandem(folder, {"validate", "s.ssp"});
  EXPECT_EQ(named.status, 2);
  EXPECT_TRUE(contains(named.err, "s.ssp:8: ")) << named.err;
  EXPECT_TRUE(contains(named.err, "did you mean 'step'")) << named.err;
}

}  // namespace
}  // namespace tandem::test
