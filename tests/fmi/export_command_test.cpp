// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdio>

#include "command.hpp"
#include "exports.hpp"

namespace tandem::test {
namespace {

const std::string simple =
    "[inputs]\nu = { unit = 'N m' }\n[blocks]\nx = { kind = 'lag', input = 'u', time = 0.1 }\n[outputs]\n"
    "x = { unit = 'N m' }\n[run]\nstop = 1\nstep = 0.01\n[run.inputs]\nu = 3\n";

TEST(ExportCommand, MakesAnFmuThatRunsAsItsSourceDoes) {
  const Scratch folder;
  folder.write("d.toml", simple);
  folder.write("s.toml", "[subsystems.d]\nsource = 'fmu:d.fmu'\n[span]\nstop = 1\n");
  for (const char* version : {"2", "3"}) {
    const Said said = tandem(folder, {"export", "d.toml", "d.fmu", "--fmi", version});
    EXPECT_EQ(said.status, 0) << said.err;
    EXPECT_TRUE(contains(said.out, std::string("d.fmu: FMI ") + version + ".0, Co-Simulation")) << said.out;
    EXPECT_TRUE(contains(said.out, "1 inputs, 1 outputs, 0 parameters, own step 0.01 s")) << said.out;
    EXPECT_EQ(tandem(folder, {"run", "d.toml", "--output", "a"}).status, 0);
    EXPECT_EQ(tandem(folder, {"run", "s.toml", "--output", "b"}).status, 0);
    EXPECT_EQ(read_text(folder.path() / "a/results.csv"), read_text(folder.path() / "b/results.csv"));
    EXPECT_EQ(tandem(folder, {"check", "fmu:d.fmu"}).status, 0);
  }
}

TEST(ExportCommand, MakesAnFmuOfModelExchange) {
  const Scratch folder;
  folder.write("d.toml", simple);
  folder.write("s.toml", "[subsystems.d]\nsource = 'fmu:d.fmu'\n[span]\nstop = 1\n");
  EXPECT_EQ(tandem(folder, {"run", "d.toml", "--output", "a"}).status, 0);
  for (const char* version : {"2", "3"}) {
    const Said said = tandem(folder, {"export", "d.toml", "d.fmu", "--type", "me", "--fmi", version});
    EXPECT_TRUE(contains(said.out, std::string("d.fmu: FMI ") + version + ".0, Model Exchange")) << said.out;
    EXPECT_EQ(tandem(folder, {"run", "s.toml", "--output", "b"}).status, 0);
    EXPECT_EQ(read_text(folder.path() / "a/results.csv"), read_text(folder.path() / "b/results.csv"));
    EXPECT_EQ(tandem(folder, {"check", "fmu:d.fmu"}).status, 0);
  }
}

TEST(ExportCommand, TakesValuesOfTheCommandLine) {
  const Scratch folder;
  folder.write("d.toml", simple);
  EXPECT_EQ(tandem(folder, {"export", "d.toml", "a.fmu", "--set", "run.inputs.u=5", "--set", "run.step=0.02"})
                .status,
            0);
  const std::string info = tandem(folder, {"info", "fmu:a.fmu"}).out;
  EXPECT_TRUE(contains(info, "u  unit N m, start value 5") && contains(info, "own step: 0.02 s")) << info;
  EXPECT_EQ(tandem(folder, {"export", "diagram:d.toml?step=0.05&integrator=cvode_bdf", "b.fmu"}).status, 0);
  EXPECT_TRUE(contains(tandem(folder, {"info", "fmu:b.fmu"}).out, "state cannot be had"))
      << tandem(folder, {"info", "fmu:b.fmu"}).out;
}

TEST(ExportCommand, RefusesInOneSentence) {
  const Scratch folder;
  folder.write("d.toml", simple);
  folder.write("empty.toml", "");
  const auto refused = [&](const std::vector<std::string>& words, const std::string& sentence) {
    const Said said = tandem(folder, words);
    EXPECT_EQ(said.status, 2) << said.err;
    EXPECT_TRUE(contains(said.err, sentence)) << said.err;
  };
  refused({"export", "d.toml", "d.fmu", "--fmi", "1"}, "--fmi");
  refused({"export", "d.toml", "d.ssp", "--type", "me"}, "--type cs");
  refused({"export", "nothing.toml", "d.fmu"}, "nothing.toml' is not there");
  refused({"export", "empty.toml", "d.fmu"}, "empty.toml: the file holds nothing");
  std::filesystem::create_directory(folder.path() / "folder.fmu");
  refused({"export", "d.toml", "folder.fmu"}, "folder.fmu");
  refused({"export", "d.toml", "d.toml"}, "ends in .fmu");
  refused({"export", "d.toml", "no/such/folder/d.fmu"}, "no/such/folder/d.fmu");
  refused({"export", "diagram:d.toml?stp=1", "d.fmu"}, "'stp'");
  refused({"export", "d.toml", "d.fmu", "--set", "run.inputs.v=1"}, "input 'v' is not there");
  folder.write("d.fmu", "");
  refused({"export", "d.fmu", "e.fmu"}, "is an FMU already");
  std::filesystem::remove(folder.path() / "d.fmu");
  refused({"export", "builtin:kart", "d.fmu"}, "does not go along");
  refused({"export", "mechanism:" TANDEM_SOURCE_DIR "/scenarios/kart/spatial.toml", "d.fmu"},
          "written in C++");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "d.fmu"));
}

/// Besides what every system has: the libraries that go along.
TEST(ExportCommand, BringsALibraryThatStandsAlone) {
  const Scratch folder;
  const std::string line = "readelf -d '" TANDEM_FMU_LIBRARY "/tandem_fmu.so' | grep NEEDED > '" +
                           (folder.path() / "needed").string() + "'";
  ASSERT_EQ(std::system(line.c_str()), 0);
  std::istringstream needed(read_text(folder.path() / "needed"));
  for (std::string words; std::getline(needed, words);) {
    const std::string name = words.substr(words.find('[') + 1, words.find(']') - words.find('[') - 1);
    const bool everywhere = contains(
        "libc.so.6 libm.so.6 libstdc++.so.6 libgcc_s.so.1 ld-linux-x86-64.so.2 "
        "libasan.so.8 libubsan.so.1 libtsan.so.2",
        name);
    EXPECT_TRUE(everywhere || std::filesystem::exists(std::filesystem::path(TANDEM_FMU_LIBRARY) / name))
        << name;
  }
  for (const auto& file : std::filesystem::directory_iterator(TANDEM_FMU_LIBRARY))
    EXPECT_TRUE(contains("tandem_fmu.so libmuparser.so.2 libgomp.so.1 libomp.so.5 licences.txt",
                         file.path().filename().string()))
        << file.path();
}

}  // namespace
}  // namespace tandem::test
