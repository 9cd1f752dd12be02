// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A scenario, results and options may name any file. What is none of ours is refused by name, line and
// column, and none of its text is told: a marker word in it never comes out.
#include <gtest/gtest.h>

#include "command.hpp"
#include "tandem/error.hpp"
#include "tandem/mbs/sparse/matrix_file.hpp"

namespace tandem::test {
namespace {

namespace fs = std::filesystem;

const std::string marker = "xyzzy";

/// Texts as other programs' files have them, and such as come far in our readers before they are refused.
const std::vector<std::string> foreign_texts = {
    "root:x:0:0:xyzzy:/root:/bin/bash\nxyzzy:x:1:1:xyzzy:/:/bin/sh\n",
    "xyzzy:$6$xyzzy$xyzzy:19000:0:99999:7:::\n",
    "xyzzy",
    "xyzzy,xyzzy\nxyzzy,xyzzy\n",
    "PASSWORD=xyzzy\n",
    "[default]\nkey = xyzzy\n",
    "machine xyzzy login xyzzy password xyzzy\n",
    "-----BEGIN OPENSSH PRIVATE KEY-----\nxyzzy\n-----END OPENSSH PRIVATE KEY-----\n",
    "-----BEGIN PRIVATE KEY-----\nxyzzy\n-----END PRIVATE KEY-----\n",
    "{\"xyzzy\": xyzzy}",
    "[\"xyzzy\", xyzzy]",
    "{\"files\": xyzzy",
    "a = 1\n[a.xyzzy]\n",
    "xyzzy = 1\nxyzzy = 2\n",
    "a = \"\\xyzzy\"\n",
    "a = [1, xyzzy\n",
    "a = 2020-xyzzy\n",
    "a = 0xxyzzy\n",
    "[xyzzy\n",
    "[subsystems.xyzzy]\nsource = xyzzy\n",
    "time,xyzzy\n0,1\n1,xyzzy\n",
    "time,xyzzy,xyzzy\n0,1,2\n",
    "time,a\nxyzzy,1\n",
    "time,a\n\"xyzzy,1\n",
    "time,a\n1,1\n0,xyzzy\n",
    "rung,quantity,unit,difference,tolerance,seconds,xyzzy,xyzzy\n",
    "rung,quantity,unit,difference,tolerance,seconds\na,b,1,xyzzy,xyzzy,xyzzy\n",
    "TANDEMCPxyzzyxyzzyxyzzyxyzzyxyzzyxyzzyxyzzyxyzzyxyzzyxyzzy\n",
    "%%MatrixMarket matrix coordinate real general\n1 1 1\n1 1 xyzzy\n",
};

/// A folder with a file `foreign` and files that lead to it.
class ForeignText : public testing::Test {
 protected:
  ForeignText() {
    const std::string span = "[span]\nstop = 1.0\n";
    folder_.write("mechanism.toml", "[subsystems.a]\nsource = \"mechanism:foreign\"\n" + span);
    folder_.write("diagram.toml", "[subsystems.a]\nsource = \"diagram:foreign\"\n" + span);
    folder_.write(
        "data.toml",
        "[subsystems.a]\nsource = \"diagram:d.toml\"\ninputs.u = { file = \"foreign\", column = \"x\" }\n" +
            span);
    folder_.write(
        "d.toml",
        "[inputs]\nu = { unit = \"1\" }\n[outputs]\nu = { unit = \"1\" }\n[run]\nstep = 0.1\nstop = 1.0\n"
        "[blocks]\ng = { kind = \"gain\", input = \"u\", gain = 1.0 }\n");
    folder_.write("nested.toml",
                  "[blocks]\nc = { kind = \"diagram\", file = \"foreign\" }\n[run]\nstep = 0.1\nstop = 1\n");
    folder_.write("csv.toml",
                  "[blocks]\nc = { kind = \"csv\", file = \"foreign\", column = \"x\" }\n"
                  "[outputs]\nc = { unit = \"1\" }\n[run]\nstep = 0.1\nstop = 1\n");
    folder_.write("forced.toml",
                  read_text(TANDEM_SOURCE_DIR "/scenarios/mechanisms/spring_pendulum/spring_pendulum.toml") +
                      "\n[inputs]\nf = { unit = \"N\", file = \"foreign\", column = \"x\" }\n");
    folder_.write("reference.toml", two_mass() + "[reference]\nfile = \"foreign\"\ntolerance = 0.1\n");
    folder_.write("plain.toml", two_mass());
    folder_.write("ladder.toml",
                  two_mass() +
                      "[judge]\nquantity = \"fast.x1\"\ntolerance = 0.1\n[[ladder.rungs]]\nname = \"a\"\n"
                      "file = \"foreign\"\n[[ladder.rungs]]\nname = \"b\"\n");
    folder_.write("good.csv", "time,x\n0,1\n1,2\n");
    for (const char* name : {"about", "rows", "mechanisms", "chart"})
      fs::create_directory(folder_.path() / name);
    fs::create_symlink("../foreign", folder_.path() / "about/results.json");
    fs::create_symlink("../foreign", folder_.path() / "rows/results.csv");
    fs::create_symlink("../foreign", folder_.path() / "chart/ladder.csv");
    folder_.write("mechanisms/results.csv", "time,x\n0,1\n");
    folder_.write("mechanisms/results.json",
                  R"({"files":["results.csv"],"scenario":{"file":"s.toml","overrides":[],"values":)"
                  R"({"subsystems":{"a":{"source":"mechanism:foreign"}}}}})");
    folder_.write("own.pub", "x");
  }
  static std::string two_mass() {
    return "[subsystems.fast]\nsource = \"builtin:two_mass.fast\"\ninputs = { x2 = 0.0, v2 = 0.0 "
           "}\n[span]\nstop = "
           "0.1\n";
  }
  /// Refused, and not by its text.
  void tell_nothing(const std::vector<std::string>& arguments) {
    for (const std::string& text : foreign_texts) {
      fs::remove(folder_.path() / "foreign");
      folder_.write("foreign", text);
      fs::permissions(folder_.path() / "foreign", fs::perms::owner_read | fs::perms::owner_write);
      const Said said = tandem(folder_, arguments);
      EXPECT_NE(said.status, 0) << said.out;
      EXPECT_FALSE(contains(said.out + said.err, marker))
          << arguments[0] << " " << arguments[1] << " of " << text << ": " << said.out << said.err;
      EXPECT_TRUE(said.err.starts_with("tandem: ")) << said.err;
    }
  }
  Scratch folder_;
};

TEST_F(ForeignText, AsAScenario) {
  for (const char* command : {"validate", "info", "run", "modes", "ladder"})
    tell_nothing({command, "foreign"});
}

TEST_F(ForeignText, InAScenario) {
  for (const char* file : {"mechanism.toml", "diagram.toml", "data.toml", "nested.toml", "csv.toml",
                           "forced.toml", "reference.toml"})
    tell_nothing({"validate", file});
  tell_nothing({"run", "reference.toml", "--dry-run"});
  tell_nothing({"ladder", "ladder.toml"});
}

TEST_F(ForeignText, AsResults) {
  tell_nothing({"compare", "foreign", "good.csv"});
  tell_nothing({"compare", "good.csv", "foreign"});
  for (const char* place : {"about", "rows"}) tell_nothing({"compare", place, "good.csv"});
  for (const char* place : {"foreign", "about", "rows", "mechanisms"}) tell_nothing({"view", place});
}

TEST_F(ForeignText, AsATableOfAChartOrWhatIsSaidOfIt) {
  tell_nothing({"chart", "ladder", "--results", "chart"});
  fs::remove(folder_.path() / "chart/ladder.csv");
  folder_.write("chart/ladder.csv", "rung,quantity,difference,tolerance,seconds\na,q,1,1,1\n");
  fs::create_symlink("../foreign", folder_.path() / "chart/ladder.json");
  tell_nothing({"chart", "ladder", "--results", "chart"});
}

TEST_F(ForeignText, AsACheckpoint) { tell_nothing({"run", "plain.toml", "--resume", "foreign"}); }

TEST_F(ForeignText, AsAKey) {
  ASSERT_EQ(tandem(folder_, {"keys", "keys"}).status, 0);
  const auto key_is = [&](const std::string& name) {
    fs::remove(folder_.path() / "keys" / name);
    fs::create_symlink("../foreign", folder_.path() / "keys" / name);
  };
  const std::string tls = "tls://127.0.0.1:1?key=keys/client.key&authority=keys/authority.crt",
                    zmq = "zmq:tcp://127.0.0.1:1?deadline=0.2&key=keys/client&server_key=keys/server.pub";
  for (const std::string& uri : {tls, zmq})
    for (const char* name :
         {"authority.crt", "server.pub", "client.crt", "client.pub", "client.key", "client"}) {
      key_is(name);
      tell_nothing({"info", uri});
    }
  tell_nothing({"serve", "builtin:two_mass.slow", "--listen", "tls://127.0.0.1:0", "--key", "foreign",
                "--authority", "keys/authority.crt"});
  tell_nothing({"serve", "builtin:two_mass.slow", "--listen", "zmq:tcp://127.0.0.1:0", "--key", "foreign"});
}

/// What commands read that go on with an earlier work, or only the tests.
TEST_F(ForeignText, InTablesAndMatrices) {
  for (const std::string& text : foreign_texts) {
    const auto file = folder_.write("foreign", text);
    const auto told = [&](const auto& reading) -> std::string {
      try {
        reading();
      } catch (const Error& error) {
        return error.what();
      }
      return "";
    };
    for (const std::string& sentence :
         {told([&] { mbs::read_matrix_market(file); }), told([&] { mbs::read_compressed_columns(file); })}) {
      EXPECT_FALSE(sentence.empty()) << text;
      EXPECT_FALSE(contains(sentence, marker)) << sentence;
    }
  }
}

/// The place is told, so that one's own mistake is found.
TEST_F(ForeignText, LineAndColumnAreTold) {
  folder_.write("foreign", "a = 1\nb = = 2\n");
  EXPECT_TRUE(contains(tandem(folder_, {"validate", "foreign"}).err, "foreign:2: not TOML at column 5"));
  folder_.write("foreign", "time,a,b\n0,1,2\n1,2,3x\n");
  EXPECT_TRUE(contains(tandem(folder_, {"compare", "foreign", "good.csv"}).err, "foreign:3: column 3 holds"));
  folder_.write("foreign", "{\"a\": 1,\n \"b\": oops}");
  EXPECT_TRUE(contains(tandem(folder_, {"compare", "about", "good.csv"}).err, "not JSON: line 2, column 7"))
      << tandem(folder_, {"compare", "about", "good.csv"}).err;
}

}  // namespace
}  // namespace tandem::test
