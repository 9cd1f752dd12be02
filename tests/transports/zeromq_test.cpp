// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#if TANDEM_HAS_ZEROMQ
#include <gtest/gtest.h>

#include "child.hpp"
#include "curve_pair.hpp"
#include "refusal.hpp"
#include "run_bench.hpp"
#include "same_bits.hpp"
#include "scratch.hpp"
#include "served.hpp"

namespace tandem::test {
namespace {

namespace fs = std::filesystem;

std::vector<Recording::Rows> zeromq_masses(const std::string& slow_uri) {
  const auto fast = open("builtin:two_mass.fast?frequency_ratio=30.7", all_sources());
  const auto slow = open(slow_uri, all_sources());
  RunBench bench;
  bench.add("fast", *fast).add("slow", *slow);
  bench.connect("slow.x2", "fast.x2", "lagrange3").connect("fast.x1", "slow.x1", "lagrange3");
  return bench.run(20.0).all();
}

TEST(ZeroMq, TwoMassesGiveTheSameBitsAsInOneProcessWithAndWithoutKeys) {
  const auto expected = zeromq_masses("builtin:two_mass.slow?frequency_ratio=30.7");
  const Scratch folder;
  const CurveFolder keys;
  for (const std::string& address :
       {std::string("tcp://127.0.0.1:0"), "ipc://" + (folder.path() / "socket").string()}) {
    const Served open_server(zmq_listen(address, {}), source("builtin:two_mass.slow"));
    EXPECT_TRUE(same_bits(zeromq_masses(open_server.address() + "?frequency_ratio=30.7"), expected))
        << address;
  }
  const Served server(zmq_listen("tcp://127.0.0.1:0", keys.settings()), source("builtin:two_mass.slow"));
  EXPECT_TRUE(same_bits(zeromq_masses(server.address() + "?frequency_ratio=30.7&" + keys.query()), expected));
}

TEST(ZeroMq, OnlyTheClientsThatAreListedAreLetIn) {
  const CurveFolder keys, strangers;
  const Served server(zmq_listen("tcp://127.0.0.1:0", keys.settings()), source("builtin:two_mass.slow"));
  const auto opening = [&](const std::string& query) {
    return [&, query] { open(server.address() + "?deadline=0.5&" + query, all_sources()); };
  };
  for (const std::string& wrong :
       {"key=" + strangers.file("client").string() + "&server_key=" + keys.file("server.pub").string(),
        keys.query("client", "client"), std::string("frequency_ratio=30.7")})
    EXPECT_TRUE(refuses(ErrorCode::input_output, {server.address(), "within the deadline"}, opening(wrong)));
}

TEST(ZeroMq, ASecretThatOthersMayReadIsRefused) {
  const CurveFolder keys;
  fs::permissions(keys.file("client"), fs::perms::group_read, fs::perm_options::add);
  const auto opening = [&] { open("zmq:tcp://127.0.0.1:1?" + keys.query(), all_sources()); };
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"client'", "mode 600"}, opening));
  fs::remove(keys.file("client"));
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"client'", "not there"}, opening));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"one of key and server_key"},
                      [] { open("zmq:tcp://127.0.0.1:1?key=x", all_sources()); }));
}

TEST(ZeroMq, PlainTextStaysOnThisMachine) {
  EXPECT_TRUE(refuses(ErrorCode::not_supported, {"192.0.2.1", "--allow-plaintext"},
                      [] { open("zmq:tcp://192.0.2.1:1", all_sources()); }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'*'", "0.0.0.0"}, [] { zmq_listen("tcp://*:0", {}); }));
  EXPECT_TRUE(refuses(ErrorCode::not_supported, {"0.0.0.0"}, [] { zmq_listen("tcp://0.0.0.0:0", {}); }));
}

/// What ZeroMQ itself would take for an address beyond this machine, or another protocol.
TEST(ZeroMq, PlainTextDoesNotGetOutByTheNameOfItsHost) {
  const auto opening = [](const std::string& uri) { return [uri] { open(uri, all_sources()); }; };
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"127.1.2.3.invalid", "not known"},
                      opening("zmq:tcp://127.1.2.3.invalid:1")));
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"127.0.0.1:0;192.0.2.1", "not known"},
                      opening("zmq:tcp://127.0.0.1:0;192.0.2.1:1")));
  for (const std::string other :
       {"ws://192.0.2.1:1", "epgm://eth0;239.0.0.1:1", "tcp:", "tcp://127.0.0.1", ""})
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument,
                        {"'zmq:" + other + "'", "of the form zmq:tcp://HOST:PORT"}, opening("zmq:" + other)));
}

/// A name without a file is open to every user, and "*" leaves a folder behind.
TEST(ZeroMq, AnIpcNameIsAFilesOrRefused) {
  for (const std::string address : {"ipc://@name", "ipc://*"}) {
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'zmq:" + address + "'", "names no file"},
                        [&] { zmq_listen(address, {}); }));
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'zmq:" + address + "'", "names no file"},
                        [&] { zmq_connect(address, {}); }));
  }
}

TEST(ZeroMq, ListensAtNamesAndNumbersOfThisMachine) {
  for (const std::string address : {"tcp://localhost:0", "tcp://127.1.2.3:0"}) {
    const Served server(zmq_listen(address, {}), source("builtin:two_mass.slow"));
    EXPECT_NO_THROW(open(server.address(), all_sources())) << address;
  }
}

/// Wherever they stand: the server says its path, which may begin elsewhere.
TEST(ZeroMq, AnIpcPathIsSeenFromTheFolderOfTheScenario) {
  const Scratch folder;
  const Served server(zmq_listen("ipc://" + (folder.path() / "socket").string(), {}),
                      source("builtin:two_mass.slow"));
  Opening opening;
  opening.folder = folder.path();
  EXPECT_NO_THROW(open("zmq:ipc://socket", all_sources(), std::move(opening)));
}

/// ZeroMQ itself would remove whatever is there.
TEST(ZeroMq, AnIpcPathThatIsInUseIsRefusedAndKeepsItsFile) {
  const Scratch folder;
  const std::string path = (folder.path() / "socket").string(), other = folder.write("file", "text").string();
  const Served server(zmq_listen("ipc://" + path, {}), source("builtin:two_mass.slow"));
  for (const std::string& taken : {path, other})
    EXPECT_TRUE(refuses(ErrorCode::input_output, {"zmq:ipc://" + taken, "something is there"},
                        [&] { zmq_listen("ipc://" + taken, {}); }));
  EXPECT_EQ(read_text(other), "text");
  folder.write("socket-1", "a session's place");
  EXPECT_NO_THROW(open(server.address() + "?frequency_ratio=30.7", all_sources()));
  EXPECT_EQ(read_text(path + "-1"), "a session's place");
}

/// In a process, whose end ZeroMQ's own thread does not outlive.
TEST(ZeroMq, FilesOfIpcSocketsGoWithTheirServer) {
  const Scratch folder;
  const std::string address = "zmq:ipc://" + (folder.path() / "socket").string();
  Child server({TANDEM_COMMAND, "--quiet", "serve", "builtin:two_mass.slow", "--listen", address});
  const auto session = open(server.word_after(" at "), all_sources());
  server.signal(SIGTERM);
  EXPECT_EQ(server.status(), 0);
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

/// By its server, by ZeroMQ's own thread when that closes, and by a session's end.
TEST(ZeroMq, AnIpcSocketThatAnotherServerHasReplacedStays) {
  const Scratch folder;
  const std::string path = (folder.path() / "socket").string(), ours = path + "-1";
  auto first = std::make_unique<Served>(zmq_listen("ipc://" + path, {}), source("builtin:two_mass.slow"));
  auto session = zmq_connect("ipc://" + path, {});
  for (const std::string& file : {path, ours}) EXPECT_TRUE(fs::remove(file)) << file;
  const Served second(zmq_listen("ipc://" + path, {}), source("builtin:two_mass.slow"));
  const auto other = zmq_connect("ipc://" + path, {});
  EXPECT_TRUE(fs::exists(ours));
  session.reset();
  first.reset();
  EXPECT_TRUE(fs::exists(path));
  EXPECT_TRUE(fs::exists(ours));
  EXPECT_NO_THROW(open(second.address(), all_sources()));
}

TEST(ZeroMq, AnIpcSocketWhoseServerWasKilledIsReplaced) {
  const Scratch folder;
  const std::string address = "zmq:ipc://" + (folder.path() / "socket").string();
  Child server({TANDEM_COMMAND, "--quiet", "serve", "builtin:two_mass.slow", "--listen", address});
  EXPECT_EQ(server.word_after(" at "), address);
  server.signal(SIGKILL);
  EXPECT_EQ(server.status(), -SIGKILL);
  EXPECT_TRUE(std::filesystem::exists(address.substr(10)));
  EXPECT_NO_THROW(zmq_listen(address.substr(4), {}));
}

TEST(ZeroMq, AServerThatEndsIsToldPromptly) {
  auto server =
      std::make_unique<Served>(zmq_listen("tcp://127.0.0.1:0", {}), source("builtin:two_mass.both"));
  const std::string address = server->address();
  const auto both = open(address, all_sources());
  RunBench bench;
  Coordinator& run = bench.add("both", *both).make(10.0);
  run.initialize();
  server.reset();
  EXPECT_TRUE(
      refuses(ErrorCode::input_output, {"'both'", address, "advance", "t = 0 s"}, [&] { run.round(); }));
}

}  // namespace
}  // namespace tandem::test
#endif
