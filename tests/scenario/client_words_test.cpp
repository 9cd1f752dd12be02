// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What a client of `tandem serve` may set: each word of each source, and files that a diagram names.
#include <gtest/gtest.h>

#include "background.hpp"
#include "refusal.hpp"
#include "sources/all.hpp"

namespace tandem::test {
namespace {

namespace fs = std::filesystem;

/// As the server opens its source for a client that said `pairs`.
std::unique_ptr<Subsystem> open_for_client(const std::string& uri, const std::string& pairs) {
  Opening opening;
  opening.parameters.read(pairs, "the client", Setter::client);
  return open(uri, all_sources(), std::move(opening));
}

std::string refusal(const std::string& uri, const std::string& pairs) {
  try {
    open_for_client(uri, pairs);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

const std::string foreign = "only who serves the source may set it";

/// Every source by a URI whose place is nowhere: what is refused is refused before it is looked for.
std::map<std::string, Words> each_source() {
  const Builtins all = all_sources();
  std::map<std::string, Words> sources;
  for (const auto& [name, source] : all.models) sources["builtin:" + name] = source.words;
  for (const auto& [scheme, source] : all.schemes) sources[scheme + ":/nowhere/at.all"] = source.words;
  return sources;
}

TEST(ClientWords, EachSourceTakesFromAClientWhatIsAClientsAndNothingElse) {
  for (const auto& [uri, words] : each_source())
    for (const Word& word : words) {
      const std::string name =
          word.name.ends_with(".*") ? word.name.substr(0, word.name.size() - 1) + "x" : word.name;
      const bool refused = contains(refusal(uri, name + "=1"), foreign);
      EXPECT_EQ(refused, word.setter == Setter::operator_only) << uri << " " << name;
    }
}

TEST(ClientWords, WhatNamesProgramsSymbolsFilesAndPlacesIsTheOperators) {
  const std::map<std::string, std::vector<std::string>> theirs = {
    {"functions", {"octave", "deadline", "threads"}},
    {"lib", {"entry"}},
    {"three_functions", {"initiate", "advance", "clean_up", "step", "inputs", "outputs"}},
    {"mechanism", {"matrices", "matrices_at", "matrices_format", "threads", "threads_from"}},
    {"tcp", {"deadline", "spin"}},
    {"tls", {"deadline", "spin", "key", "authority"}},
    {"unix", {"deadline", "spin"}},
    {"spawn", {"deadline", "spin"}},
#if TANDEM_HAS_ZEROMQ
    {"zmq", {"deadline", "key", "server_key"}},
#endif
  };
  for (const auto& [scheme, words] : theirs)
    for (const std::string& word : words)
      EXPECT_NE(refusal(scheme + ":/nowhere", word + "=1").find(foreign), std::string::npos)
          << scheme << " " << word;
}

TEST(ClientWords, ASourceThatAsksForAWordItHasNotDeclaredIsTold) {
  Builtins all;
  all.models["careless"] = {words_by(Setter::client, {"mass"}), [](const Address&, Parameters& p) {
                              p.text("program", "");
                              return std::unique_ptr<Subsystem>();
                            }};
  EXPECT_TRUE(refuses(ErrorCode::internal, {"'program'", "does not declare it"},
                      [&] { open("builtin:careless?program=x", all); }));
}

/// A diagram that names files by parameters: one of a CSV file, one of a diagram in it.
constexpr const char* names_files = R"(
[parameters]
data = { value = "../beyond/given.csv" }
pick = { value = "../beyond/one.csv", allowed = ["../beyond/one.csv", "../beyond/two.csv"] }
part = { value = "part.toml" }
part_data = { value = "x.csv" }
[blocks]
a = { kind = "csv", file = "$data", column = "x" }
b = { kind = "csv", file = "$pick", column = "x" }
c = { kind = "diagram", file = "$part", data = "$part_data" }
[outputs]
a = { unit = "1" }
[run]
step = 0.1
)";
constexpr const char* part = R"(
[parameters]
data = { value = "x.csv" }
[blocks]
d = { kind = "csv", file = "$data", column = "x" }
[outputs]
d = { unit = "1" }
)";

/// The folder `served` with the diagram, and beside it the folder `beyond`.
class FilesOfAClient : public testing::Test {
 protected:
  FilesOfAClient() {
    for (const char* folder : {"served/below", "beyond"}) fs::create_directories(scratch_.path() / folder);
    for (const char* file : {"served/x.csv", "served/below/x.csv", "beyond/given.csv", "beyond/one.csv",
                             "beyond/two.csv", "beyond/secret.csv"})
      scratch_.write(file, "time,x\n0,1\n1,2\n");
    scratch_.write("served/d.toml", names_files);
    for (const char* file : {"served/part.toml", "served/below/part.toml", "beyond/part.toml"})
      scratch_.write(file, part);
    fs::create_symlink("../beyond/secret.csv", scratch_.path() / "served/link.csv");
    fs::create_directory_symlink("../beyond", scratch_.path() / "served/folder");
    fs::create_symlink("circle", scratch_.path() / "beyond/circle");
  }
  std::string told(const std::string& pairs) const {
    return refusal("diagram:" + (scratch_.path() / "served/d.toml").string(), pairs);
  }
  Scratch scratch_;
};

TEST_F(FilesOfAClient, TheDefaultTheAllowedAndThoseBelowTheFolder) {
  for (const std::string& pairs : std::vector<std::string>{
           "step=0.1", "data=../beyond/given.csv", "pick=../beyond/two.csv", "data=x.csv", "data=below/x.csv",
           "data=below/../x.csv", "part=below/part.toml", "part_data=below/x.csv"})
    EXPECT_EQ(told(pairs), "") << pairs;
}

TEST_F(FilesOfAClient, NoneBeyondIt) {
  const std::string secret = (scratch_.path() / "beyond/secret.csv").string();
  for (const std::string& pairs : std::vector<std::string>{
           std::string("data=../beyond/secret.csv"), "data=" + secret, std::string("data=link.csv"),
           std::string("data=folder/secret.csv"), std::string("data=/etc/shadow"),
           std::string("data=/nowhere"), std::string("data=../beyond/circle"),
           std::string("part=../beyond/part.toml"), std::string("part=folder/part.toml"),
           std::string("part_data=../beyond/secret.csv"), std::string("part_data=link.csv")})
    EXPECT_TRUE(contains(told(pairs), "allowed from a client")) << pairs << ": " << told(pairs);
  EXPECT_TRUE(contains(told("pick=../beyond/secret.csv"), "allowed is ../beyond/one.csv"));
}

TEST_F(FilesOfAClient, WhoServesItNamesAny) {
  const std::string uri = "diagram:" + (scratch_.path() / "served/d.toml").string();
  EXPECT_NO_THROW(
      open(uri + "?data=../beyond/secret.csv&part=../beyond/part.toml&part_data=one.csv", all_sources()));
}

/// A mechanism whose words may be files' names.
TEST_F(FilesOfAClient, OfAMechanismTheDefaultAndTheAllowed) {
  scratch_.write("served/m.toml", R"(
dimension = 2
[parameters]
m = { value = 1, unit = "kg" }
data = { value = "x.csv" }
pick = { value = "x", allowed = ["x", "../beyond/one.csv"] }
[points]
P = { at = [0, 0] }
[masses]
m = { point = "P", mass = "$m" }
[inputs]
F = { unit = "N", file = "$data", column = "x" }
[forces]
f = { point = "P", direction = [1, 0], magnitude = "F" }
[outputs]
x = { position = "P.x" }
[run]
step = 0.1
)");
  const auto says = [&](const std::string& pairs) {
    return refusal("mechanism:" + (scratch_.path() / "served/m.toml").string(), pairs);
  };
  for (const char* pairs : {"step=0.1", "m=2", "data=x.csv", "pick=../beyond/one.csv"})
    EXPECT_EQ(says(pairs), "") << pairs;
  for (const char* pairs : {"data=/etc/shadow", "data=below/x.csv", "data=../beyond/secret.csv"})
    EXPECT_TRUE(contains(says(pairs), "allowed from a client")) << pairs << ": " << says(pairs);
  EXPECT_TRUE(contains(says("pick=/etc/shadow"), "allowed is x, ../beyond/one.csv"));
}

/// Each attack as it was made: by a server and a client, with the client's text.
class AttackedServer : public testing::Test {
 protected:
  Said attack(const std::string& source, const std::string& pairs) {
    const std::string socket = (folder_.path() / "socket").string();
    Background server(folder_, {"serve", source, "--listen", "unix:" + socket});
    for (int k = 0; k < 5000 && !fs::exists(socket); ++k) usleep(1000);
    const Said said = tandem(folder_, {"info", "unix:" + socket + "?" + pairs});
    again_ = tandem(folder_, {"info", "unix:" + socket}).status;
    status_ = server.end_by(SIGTERM);
    return said;
  }
  Scratch folder_;
  int again_ = -1, status_ = -1;
};

TEST_F(AttackedServer, StartsNoProgramForAClient) {
  const auto program = folder_.write("program", "#!/bin/sh\ntouch started\n");
  fs::permissions(program, fs::perms::owner_all);
  const Said said = attack(std::string("functions:") + TANDEM_SOURCE_DIR "/scenarios/functions/pendulum.m",
                           "step=0.01&octave=" + program.string());
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said.err, "'octave'") && contains(said.err, foreign)) << said.err;
  EXPECT_FALSE(fs::exists(folder_.path() / "started"));
}

TEST_F(AttackedServer, CallsNoSymbolForAClient) {
  const std::string library = std::string("lib:") + TANDEM_FILE_LIBRARIES + "/engine_library.so";
  for (const std::string symbol : {"abort", "exit", "environ"}) {
    const Said said = attack(library, "entry=" + symbol);
    EXPECT_EQ(said.status, 2);
    EXPECT_TRUE(contains(said.err, "'entry'") && contains(said.err, foreign)) << said.err;
    EXPECT_EQ(status_, 0) << symbol;
  }
}

TEST_F(AttackedServer, TellsNoFilesOfTheRelay) {
  for (const std::string file : {"/etc/shadow", "/nowhere"}) {
    const Said said = attack("tls://127.0.0.1:1", "key=" + file);
    EXPECT_TRUE(contains(said.err, foreign) && !contains(said.err, file)) << said.err;
  }
}

}  // namespace
}  // namespace tandem::test
