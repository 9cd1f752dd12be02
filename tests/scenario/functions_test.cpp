// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Models whose terms are functions elsewhere, from the command line and from Octave.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "../transports/child.hpp"
#include "background.hpp"
#include "command.hpp"

namespace tandem {
namespace {

using test::Said;
using test::Scratch;
using test::tandem;

const std::string examples = std::string(TANDEM_SOURCE_DIR) + "/scenarios/functions/";

TEST(FunctionModels, ASourceThatIsNoModelIsRefused) {
  const Scratch folder;
  folder.write(
      "s.toml",
      "[subsystems.p]\nsource = \"functions:absent.so\"\nparameters = { step = 1e-3 }\n[span]\nstop = 1\n");
  const Said absent = tandem(folder, {"run", "s.toml"});
  EXPECT_EQ(absent.status, 2);
  EXPECT_NE(absent.err.find("s.toml:2"), std::string::npos) << absent.err;
  EXPECT_NE(absent.err.find("absent.so"), std::string::npos) << absent.err;
  const Said step = tandem(folder, {"info", "functions:" + examples + "pendulum.m"});
  EXPECT_EQ(step.status, 2);
  EXPECT_NE(step.err.find("no own step"), std::string::npos) << step.err;
}

/// Native code of functions, too.
TEST(FunctionModels, ALibraryRunsInAProcessOfItsOwn) {
  const Scratch folder;
  folder.write("s.toml", "[subsystems.p]\nsource = \"functions:" TANDEM_FILE_LIBRARIES
                         "/model_functions_none.so\"\nparameters = { step = 1e-3 }\n[span]\nstop = 0.1\n");
  EXPECT_EQ(tandem(folder, {"run", "s.toml", "--output", "here"}).status, 0);
  const Said said =
      tandem(folder, {"run", "s.toml", "--output", "there", "--set", "subsystems.p.isolate=true"});
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_EQ(test::read_text(folder.path() / "here/results.csv"),
            test::read_text(folder.path() / "there/results.csv"));
}

/// Of the program that evaluates a model, and of what that has started.
TEST(FunctionModels, NothingIsLeftOfTheirProgramWhenTheRunIsKilled) {
  const Scratch folder;
  const auto program = folder.write("program", "#!/bin/sh\nsleep 1000 &\necho $$ $! > processes\nwait\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  folder.write("model.m", "");
  folder.write(
      "s.toml",
      "[subsystems.p]\nsource = \"functions:model.m\"\n[subsystems.p.parameters]\nstep = 1e-3\noctave = \"" +
          program.string() + "\"\n[span]\nstop = 1\n");
  test::Background run(folder, {"run", "s.toml"});
  ASSERT_TRUE(run.wait_for_file(folder.path() / "processes")) << run.err();
  pid_t evaluates = 0, started = 0;
  std::istringstream(test::read_text(folder.path() / "processes")) >> evaluates >> started;
  run.end_by(SIGKILL);
  EXPECT_TRUE(test::ends(evaluates));
  EXPECT_TRUE(test::ends(started));
}

#ifdef TANDEM_OCTAVE
TEST(FunctionModels, TheExamplesInOctaveRun) {
  const Scratch folder;
  for (const char* name : {"pendulum", "double_pendulum"}) {
    const Said said = tandem(folder, {"run", examples + name + ".toml", "--set", "span.stop=0.01"});
    EXPECT_EQ(said.status, 0) << name << ": " << said.err;
    const std::string csv = test::read_text(folder.path() / "results" / name / "results.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 12) << csv;
  }
}

TEST(FunctionModels, AnErrorInOctaveEndsTheRunWithItsSentenceAndWhatWasRecorded) {
  const Scratch folder;
  std::string model = test::read_text(examples + "pendulum.m");
  const std::string line = "function force = air (t, q, v)\n";
  model.insert(model.find(line) + line.size(), "  if (t > 0.0045) error (\"no air at %g s\", t); end\n");
  folder.write("pendulum.m", model);
  folder.write("pendulum.toml", test::read_text(examples + "pendulum.toml"));
  const Said said = tandem(folder, {"run", "pendulum.toml", "--output", "o"});
  EXPECT_EQ(said.status, 1);
  EXPECT_NE(said.err.find("'pendulum'"), std::string::npos) << said.err;
  EXPECT_NE(said.err.find("forces at t = 0.005 s: no air at 0.005 s"), std::string::npos) << said.err;
  const std::string csv = test::read_text(folder.path() / "o" / "results.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 6) << csv;  // the names, 0 to 4 ms
}
#endif

#ifdef TANDEM_MEX_FOLDER
/// What Octave prints after these lines, or its error.
std::string octave(const Scratch& folder, const std::string& lines) {
  folder.write("drive.m", "addpath (\"" TANDEM_MEX_FOLDER "\", \"" + examples + "\");\ntry\n" + lines +
                              "catch failure\n  disp (failure.message);\nend\n");
  const std::string drive = (folder.path() / "drive.m").string(), out = (folder.path() / "said").string();
  const std::string command = TANDEM_OCTAVE " --quiet --norc " + test::shell_quoted(drive);
  EXPECT_EQ(std::system((command + " > " + test::shell_quoted(out)).c_str()), 0);
  return test::read_text(out);
}

TEST(OctaveDrives, TheMultibodyCoreAndGetsTheMotion) {
  const Scratch folder;
  EXPECT_EQ(octave(folder,
                   "m = tandem_mbs (pendulum (), struct (\"step\", 1e-3, \"stop\", 0.1));\n"
                   "printf (\"%d %d %g\", size (m.q), m.time(end));\n"
                   "printf (\" %d\", all (abs (sum (m.q.^2, 2) - 0.25) < 1e-9), m.iterations >= 100);\n"),
            "101 2 0.1 1 1");
}

TEST(OctaveDrives, AndGetsItsErrorsAsErrorsOfOctave) {
  const Scratch folder;
  const auto says = [&](const std::string& lines, const std::string& text) {
    const std::string said =
        octave(folder, "p = pendulum ();\ns = struct (\"step\", 1e-3, \"stop\", 0.1);\n" + lines);
    EXPECT_NE(said.find(text), std::string::npos) << said;
  };
  says("tandem_mbs (p);\n", "it has 1 arguments; allowed is (model, settings)");
  says("tandem_mbs (3, s);\n", "the model is not a struct");
  says("tandem_mbs (p, 3);\n", "the settings are not a struct");
  says("s.stepp = 3; tandem_mbs (p, s);\n", "stepp");
  says("s.step = 0; tandem_mbs (p, s);\n", "allowed are a step above 0");
  says("s.step = {}; tandem_mbs (p, s);\n", "setting 'step' is no number");
  says("p.variables = 3; tandem_mbs (p, s);\n", "variables is no cell array of texts");
  says("p.q = single (p.q); tandem_mbs (p, s);\n", "q is no full real matrix");
  says("p.forces = @(t, q, v) error (\"boom at %g s\", t); tandem_mbs (p, s);\n",
       "forces at t = 0 s: boom at 0 s");
  says("p.forces = @(t, q, v) [1, 2]; tandem_mbs (p, s);\n", "forces at t = 0 s is 1 x 2; allowed is 2 x 1");
  says("p.forces = @(t, q, v) [NaN; 0]; tandem_mbs (p, s);\n", "forces at t = 0 s is nan at (1, 1)");
}
#endif

}  // namespace
}  // namespace tandem
