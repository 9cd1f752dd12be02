// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#if TANDEM_HAS_ZEROMQ
#include <gtest/gtest.h>

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

/// Key files of a name, in a folder.
CurveKeys write_keys(const Scratch& folder, const std::string& name) {
  const CurveKeys keys = make_curve_keys();
  folder.write(name, keys.secret_key + "\n");
  folder.write(name + ".pub", keys.public_key + "\n");
  fs::permissions(folder.path() / name, fs::perms::owner_read | fs::perms::owner_write);
  return keys;
}

std::string with_keys(const Scratch& folder, const std::string& client, const std::string& server) {
  return "frequency_ratio=30.7&key=" + (folder.path() / client).string() +
         "&server_key=" + (folder.path() / server).string() + ".pub";
}

TEST(ZeroMq, TwoMassesGiveTheSameBitsAsInOneProcessWithAndWithoutKeys) {
  const auto expected = zeromq_masses("builtin:two_mass.slow?frequency_ratio=30.7");
  const Scratch folder;
  ZmqSettings curve;
  curve.keys = write_keys(folder, "server");
  curve.clients = {write_keys(folder, "client").public_key};
  for (const std::string& address :
       {std::string("tcp://127.0.0.1:0"), "ipc://" + (folder.path() / "socket").string()}) {
    const Served open_server(zmq_listen(address, {}), source("builtin:two_mass.slow"));
    EXPECT_TRUE(same_bits(zeromq_masses(open_server.address() + "?frequency_ratio=30.7"), expected))
        << address;
  }
  const Served server(zmq_listen("tcp://127.0.0.1:0", curve), source("builtin:two_mass.slow"));
  EXPECT_TRUE(
      same_bits(zeromq_masses(server.address() + "?" + with_keys(folder, "client", "server")), expected));
}

TEST(ZeroMq, OnlyTheClientsThatAreListedAreLetIn) {
  const Scratch folder;
  ZmqSettings curve;
  curve.keys = write_keys(folder, "server");
  curve.clients = {write_keys(folder, "client").public_key};
  write_keys(folder, "stranger");
  const Served server(zmq_listen("tcp://127.0.0.1:0", curve), source("builtin:two_mass.slow"));
  const auto opening = [&](const std::string& query) {
    return [&, query] { open(server.address() + "?deadline=0.5&" + query, all_sources()); };
  };
  for (const std::string& wrong :
       {with_keys(folder, "stranger", "server"), with_keys(folder, "client", "client"),
        std::string("frequency_ratio=30.7")})
    EXPECT_TRUE(refuses(ErrorCode::input_output, {server.address(), "within the deadline"}, opening(wrong)));
}

TEST(ZeroMq, ASecretThatOthersMayReadIsRefused) {
  const Scratch folder;
  write_keys(folder, "client");
  write_keys(folder, "server");
  fs::permissions(folder.path() / "client", fs::perms::group_read, fs::perm_options::add);
  const auto opening = [&] {
    open("zmq:tcp://127.0.0.1:1?" + with_keys(folder, "client", "server"), all_sources());
  };
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"client'", "mode 600"}, opening));
  fs::remove(folder.path() / "client");
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"client'", "not there"}, opening));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"one of key and server_key"},
                      [] { open("zmq:tcp://127.0.0.1:1?key=x", all_sources()); }));
}

TEST(ZeroMq, PlainTextStaysOnThisMachine) {
  EXPECT_TRUE(refuses(ErrorCode::not_supported, {"192.0.2.1", "--allow-plaintext"},
                      [] { open("zmq:tcp://192.0.2.1:1", all_sources()); }));
  EXPECT_TRUE(refuses(ErrorCode::not_supported, {"(*)"}, [] { zmq_listen("tcp://*:0", {}); }));
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
