// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What commands that only look at a scenario start of it: nothing, unless --run-programs is said.
#include <gtest/gtest.h>

#include <cstdlib>

#include "command.hpp"

namespace tandem::test {
namespace {

namespace fs = std::filesystem;

/// A source that is code; when it is opened there is a file `started`.
struct CodeSource {
  const char* name;
  std::string lines;  ///< of [subsystems.motor]
};

const std::string telling = TANDEM_TELLING_LIBRARY;

const std::vector<CodeSource> code_sources = {
    {"command", "command = [\"touch\", \"started\"]"},
    {"spawn", "source = \"spawn:touch started\""},
    {"lib", "source = \"lib:" + telling + "\""},
    {"three_functions", "source = \"three_functions:" + telling +
                            "\"\nparameters = { step = 0.1, inputs = \"speed:rad/s\", outputs = \"torque:N "
                            "m=0\" }"},
    {"functions", "source = \"functions:" + telling + "\"\nparameters = { step = 0.1 }"},
    {"octave", "source = \"functions:model.m\"\nparameters = { step = 0.1, octave = \"./program\" }"}};

/// Line 3 is the first of the motor's.
std::string scene(const std::string& motor) {
  return "name = \"scene\"\n[subsystems.motor]\n" + motor + R"(
[subsystems.linkage]
source = "mechanism:linkage.toml"
parameters = { step = 0.01 }
[[connections]]
from = "linkage.speed"
to = "motor.speed"
reconstruction = "lagrange2"
[[connections]]
from = "motor.torque"
to = "linkage.torque"
reconstruction = "lagrange2"
[judge]
quantity = "motor.torque"
tolerance = 0.1
[record]
ports = ["motor.torque", "linkage.speed"]
[span]
stop = 1.0
)";
}

class StrangersScenario : public testing::Test {
 protected:
  StrangersScenario() {
    folder_.write("linkage.toml", read_text(TANDEM_SOURCE_DIR "/scenarios/engine_linkage/linkage.toml"));
    folder_.write("model.m", "function s = model () s = struct (); end\n");
    fs::permissions(folder_.write("program", "#!/bin/sh\ntouch started\n"), fs::perms::owner_all);
  }
  Said say(std::vector<std::string> arguments) {
    fs::remove(folder_.path() / "started");
    return tandem(folder_, arguments);
  }
  bool started() const { return fs::exists(folder_.path() / "started"); }
  /// Of the scene with a motor that is a program, after changes to the text.
  Said validated(const std::string& from, const std::string& to) {
    std::string text = scene("command = [\"touch\", \"started\"]");
    text.replace(text.find(from), from.size(), to);
    folder_.write("s.toml", text);
    return say({"validate", "s.toml"});
  }
  Scratch folder_;
};

const std::vector<std::vector<std::string>> looks = {
    {"validate", "s.toml"}, {"info", "s.toml"}, {"run", "s.toml", "--dry-run"}};

TEST_F(StrangersScenario, IsLookedAtWithoutARunOfItsCode) {
  for (const CodeSource& source : code_sources)
    for (const auto& look : looks) {
      folder_.write("s.toml", scene(source.lines));
      const Said said = say(look);
      EXPECT_EQ(said.status, 0) << source.name << ": " << said.err;
      EXPECT_FALSE(started()) << source.name << " by " << look[0];
      for (const char* words :
           {"s.toml: checked in part\n", "s.toml:3: subsystem 'motor' is left out", "--run-programs"})
        EXPECT_TRUE(contains(said.out, words)) << source.name << " by " << look[0] << ": " << said.out;
      EXPECT_FALSE(contains(said.out, ": ok")) << said.out;
    }
}

TEST_F(StrangersScenario, IsRunWhenThatIsSaid) {
  for (const CodeSource& source : code_sources)
    for (auto look : looks) {
      folder_.write("s.toml", scene(source.lines));
      look.emplace_back("--run-programs");
      say(look);
      EXPECT_TRUE(started()) << source.name << " by " << look[0];
    }
}

TEST_F(StrangersScenario, ASourceOnTheCommandLineIsTheUsersOwn) {
  say({"info", "spawn:touch started"});
  EXPECT_TRUE(started());
}

TEST_F(StrangersScenario, WithoutCodeItIsCheckedWhole) {
  for (const char* command : {"validate", "run"}) {
    std::vector<std::string> look{command, two_mass_file("two_mass.toml")};
    if (look[0] == "run") look.emplace_back("--dry-run");
    const Said said = say(look);
    EXPECT_EQ(said.status, 0) << said.err;
    EXPECT_TRUE(contains(said.out, ": ok")) << said.out;
    EXPECT_FALSE(contains(said.out, "in part")) << said.out;
  }
}

/// What is wrong with the rest is told as ever, by its line.
TEST_F(StrangersScenario, TheRestIsChecked) {
  const auto refused = [&](const std::string& from, const std::string& to, const std::string& words) {
    const Said said = validated(from, to);
    EXPECT_EQ(said.status, 2) << to << said.out;
    EXPECT_TRUE(contains(said.err, words)) << said.err;
    EXPECT_FALSE(started()) << to;
  };
  refused("step = 0.01", "stepp = 0.01", "s.toml:");
  refused("mechanism:linkage.toml", "mechanism:absent.toml", "s.toml:5");
  refused("from = \"linkage.speed\"", "from = \"linkage.sped\"",
          "s.toml:8: subsystem 'linkage': output 'sped'");
  refused("to = \"linkage.torque\"", "to = \"linkage.torqe\"",
          "s.toml:13: subsystem 'linkage': input 'torqe'");
  refused("from = \"motor.torque\"", "from = \"moter.torque\"", "did you mean 'motor'");
  refused("\"linkage.speed\"]", "\"linkage.sped\"]", "s.toml:19: recorded output 'linkage.sped'");
  refused("quantity = \"motor.torque\"", "quantity = \"linkage.x\"", "judge.quantity");
  refused("to = \"linkage.torque\"", "to = \"motor.torque\"", "linkage.torque is not connected");
  refused("[span]", "[reference]\nfile = \"absent.csv\"\ntolerance = 0.1\n[span]", "absent.csv");
  refused("\"started\"]", "\"started\"]\nparameters = { deadline = -1 }", "deadline");
  refused("command = [\"touch\", \"started\"]", "source = \"lib:absent.so\"", "absent.so' is not there");
  refused("command = [\"touch\", \"started\"]", "source = \"functions:model.m\"", "no own step");
  refused("command = [\"touch\", \"started\"]", "source = \"nonsense:x\"", "s.toml:3");
}

TEST_F(StrangersScenario, ConnectionsBetweenWhatIsKnownAreChecked) {
  const std::string more =
      "[subsystems.other]\nsource = \"mechanism:linkage.toml\"\nparameters = { step = 0.01 }\n"
      "[[connections]]\nreconstruction = \"lagrange1\"\nfrom = \"linkage.speed\"\nto = "
      "\"other.torque\"\n[span]";
  const Said said = validated("[span]", more);
  EXPECT_EQ(said.status, 2) << said.out;
  EXPECT_TRUE(contains(said.err, "'rad/s' to 'N m'")) << said.err;
}

TEST_F(StrangersScenario, AStartThatCannotBeIsTold) {
  folder_.write("linkage.toml", read_text(folder_.path() / "linkage.toml") +
                                    "\n[distances]\nfar = { points = [\"A1\", \"B0\"], length = 99 }\n");
  const Said said = validated("[span]", "[span]");
  EXPECT_EQ(said.status, 2) << said.out;
  EXPECT_TRUE(contains(said.err, "'linkage'") && contains(said.err, "far")) << said.err;
}

/// What decides whether the code may be run is seen as it is.
TEST_F(StrangersScenario, ItsWordsReachTheTerminalWithControlCharactersShown) {
  const Said said = validated("\"started\"]", "\"started\\u001b[2K\"]");
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_TRUE(contains(said.out, "started\\x1b[2K")) << said.out;
  EXPECT_FALSE(contains(said.out, "\x1b")) << said.out;
}

/// Names and texts of every kind, wherever they are told.
TEST_F(StrangersScenario, NothingOfItReachesTheTerminalRaw) {
  const std::string beep = "\\u001b[31m\\u0007";
  const std::string parts = "[subsystems.linkage]\nsource = \"diagram:d.toml\"\n[span]\nstop = 1.0\n";
  folder_.write("d.toml",
                "name = \"" + beep + "\"\ndescription = \"" + beep + "\"\n[run]\nstep = 0.1\n[blocks]\n\"" +
                    beep + "\" = { kind = 'constant', value = 1 }\n[outputs]\ny = { unit = '1', from = \"" +
                    beep + "\" }\n");
  folder_.write("names.toml", "name = \"" + beep + "\"\ndescription = \"" + beep + "\"\n" + parts);
  folder_.write("source.toml", "[subsystems.a]\nsource = \"lib:" + beep + ".so\"\n[span]\nstop = 1.0\n");
  folder_.write("key.toml", "\"" + beep + "\" = 1\n" + parts);
  for (const std::string file : {"d.toml", "names.toml", "source.toml", "key.toml"})
    for (const std::vector<std::string>& how : {std::vector<std::string>{"info", file},
                                                {"validate", file},
                                                {"run", file, "--dry-run"},
                                                {"info", "--dot", file}}) {
      const Said said = say(how);
      EXPECT_EQ((said.out + said.err).find_first_of("\x1b\x07"), std::string::npos) << how[0] << ' ' << file;
    }
  EXPECT_TRUE(contains(say({"info", "names.toml"}).out, "\\x1b[31m\\x07")) << say({"info", "names.toml"}).out;
}

/// Also in the file of a mechanism that somebody else has made.
TEST_F(StrangersScenario, AMechanismsFileWritesNoMatricesWhereItIsLookedAt) {
  const std::string text =
      read_text(folder_.path() / "linkage.toml") + "\n[run]\nstep = 0.01\nmatrices = \"m\"\n";
  folder_.write("m.toml", text);
  for (const std::vector<std::string>& how :
       {std::vector<std::string>{"info", "mechanism:m.toml"},
        {"info", "m.toml"},
        {"check", "mechanism:m.toml"},
        {"info", "builtin:engine_linkage.linkage?step=0.01&matrices=m"}}) {
    EXPECT_EQ(say(how).status, 0) << say(how).err;
    EXPECT_FALSE(fs::exists(folder_.path() / "m")) << how[0];
  }
}

TEST_F(StrangersScenario, WritesNoMatricesWhereItIsLookedAt) {
  const std::string plain = "parameters = { step = 0.01 }";
  for (const std::string with :
       {"parameters = { step = 0.01, matrices = \"m\" }", "parameters = { step = 0.01 } # ?"}) {
    std::string text = scene("source = \"builtin:none\"");
    text = text.substr(text.find("[subsystems.linkage]"),
                       text.find("[[conn") - text.find("[subsystems.linkage]"));
    text.replace(text.find(plain), plain.size(), with);
    if (with.ends_with("?")) text.replace(text.find("linkage.toml"), 12, "linkage.toml?matrices=m");
    folder_.write("s.toml", text + "inputs = { torque = 0.0 }\n[span]\nstop = 1.0\n");
    for (auto look : looks) {
      EXPECT_EQ(say(look).status, 0) << say(look).err;
      EXPECT_FALSE(fs::exists(folder_.path() / "m")) << look[0] << with;
    }
    const Said said = say({"run", "s.toml", "--dry-run", "--dump-matrices", "m"});
    EXPECT_FALSE(fs::exists(folder_.path() / "m")) << said.err;
  }
  EXPECT_EQ(say({"run", "s.toml"}).status, 0);
  EXPECT_TRUE(fs::exists(folder_.path() / "m"));
}

TEST_F(StrangersScenario, ItsResultsAreViewedAndComparedWithoutARunOfItsCode) {
  fs::create_directory(folder_.path() / "results");
  for (const CodeSource& source : code_sources) {
    const std::string uri = source.lines.substr(0, 6) == "source"
                                ? source.lines.substr(10, source.lines.find('"', 10) - 10)
                                : std::string("spawn:touch started");
    folder_.write("results/results.json",
                  R"({"files":["results.csv"],"scenario":{"file":"s.toml","overrides":[],"values":{)"
                  R"("subsystems":{"motor":{"source":")" +
                      uri + R"(","command":["touch","started"]}}}}})");
    folder_.write("results/results.csv", "time,x\n0,1\n1,2\n");
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"view", "results"}, {"compare", "results", "results"}}) {
      const Said said = say(command);
      EXPECT_TRUE(said.status == 0 || contains(said.err, "without the libraries of the page")) << said.err;
      EXPECT_FALSE(started()) << source.name << " by " << command[0];
    }
  }
}

TEST_F(StrangersScenario, ModesOpenNoSourceOfIt) {
  folder_.write("s.toml", scene("command = [\"touch\", \"started\"]"));
  EXPECT_EQ(say({"modes", "s.toml"}).status, 0) << say({"modes", "s.toml"}).err;
  EXPECT_FALSE(started());
}

TEST_F(StrangersScenario, TheCommandsThatRunItSayThatItIsCode) {
  for (const char* command : {"run", "ladder", "sweep"})
    EXPECT_TRUE(contains(say({command, "--help"}).out, "A scenario is code")) << command;
  EXPECT_EQ(say({"run", "s.toml", "--run-programs"}).status, 2);
  EXPECT_EQ(say({"info", "builtin:two_mass.slow", "--run-programs"}).status, 2);
}

/// A chart is a script that gnuplot runs, with texts of the results in it.
TEST_F(StrangersScenario, AChartOfItsResultsRunsNoCode) {
  if (std::system("command -v gnuplot > /dev/null") != 0) GTEST_SKIP() << "gnuplot is absent";
  const std::string code = "'; system('touch started'); '", quoted = "`touch started`";
  folder_.write("t.json",
                R"~({"made":{"tandem":"`touch started`","commit":"'; system('touch started')"},)~"
                R"~("units":{"y":"`touch started`"},"norms":{"y":"'; system('touch started'); '"}})~");
  folder_.write("t.csv", "how,\"`touch started`\",x,y,status\n" + code + "," + quoted + ",1,1,ok\n" + quoted +
                             "," + code + ",2,2," + code + "\n");
  for (const std::string kind :
       {"'curves'\nx = 'x'\ny = 'y'\nseries = 'how'\n", "'work'\ncost = 'x'\nerror = 'y'\npanels = 'how'\n",
        "'map'\nrows = 'how'\ncolumns = 'x'\nvalue = 'y'\nlimits = [1]\nbest = 1\n",
        "'traces'\nx = 'x'\ny = 'y'\nseries = 'how'\njumps = 'how'\n",
        "'table'\nrows = 'how'\ncells = 'y'\n"}) {
    folder_.write("c.toml", "[[charts]]\nname = 'c'\ntable = 't'\nkind = " + kind);
    const Said said = say({"chart", "c.toml", "--results", "."});
    EXPECT_EQ(said.status, 0) << said.err;
    EXPECT_FALSE(started()) << kind;
  }
}

}  // namespace
}  // namespace tandem::test
