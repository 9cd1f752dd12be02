// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "refusal.hpp"
#include "run_bench.hpp"
#include "same_bits.hpp"
#include "scratch.hpp"
#include "served.hpp"

namespace tandem::test {
namespace {

/// The two-mass test with the sides from these sources.
std::vector<Recording::Rows> two_masses(const std::string& fast_uri, const std::string& slow_uri,
                                        const std::string& schedule) {
  const auto fast = open(fast_uri, all_sources()), slow = open(slow_uri, all_sources());
  RunBench bench;
  bench.add("fast", *fast).add("slow", *slow).schedule(schedule);
  bench.connect("slow.x2", "fast.x2", "lagrange3").connect("fast.x1", "slow.x1", "lagrange3");
  return bench.run(20.0).all();
}

TEST(Sockets, TwoMassesGiveTheSameBitsAsInOneProcess) {
  const Scratch folder;
  const std::string ratio = "?frequency_ratio=30.7";
  for (const std::string& address :
       {std::string("tcp://localhost:0"), "unix:" + (folder.path() / "socket").string()}) {
    const Served fast(listen(address, {}), source("builtin:two_mass.fast"));
    const Served slow(listen("tcp://127.0.0.1:0", {}), source("builtin:two_mass.slow"));
    for (const std::string schedule : {"slowest-first", "fastest-first", "parallel"})
      EXPECT_TRUE(
          same_bits(two_masses(fast.address() + ratio, slow.address() + ratio, schedule),
                    two_masses("builtin:two_mass.fast" + ratio, "builtin:two_mass.slow" + ratio, schedule)))
          << address << ", " << schedule;
  }
}

TEST(Sockets, EachSessionHasParametersOfItsOwn) {
  const Served server(listen("tcp://127.0.0.1:0", {}), source("builtin:two_mass.slow"));
  const auto first_step = [&](const std::string& parameters) {
    const auto s = open(server.address() + parameters, all_sources());
    std::vector<double> memory(static_cast<std::size_t>(s->info().row_size()));
    Samples y(memory.data(), s->info().row_size(), 1);
    const double u0 = 0.0;
    return s->initialize(0.0, 1.0, {&u0, 1}, y).next_time;
  };
  EXPECT_EQ(first_step("?frequency_ratio=25"), 0.25);
  EXPECT_EQ(first_step("?frequency_ratio=50"), 0.5);
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {server.address(), "hello", "frequency_rate"},
                      [&] { first_step("?frequency_rate=50"); }));
}

TEST(Sockets, AnAddressThatCanNotBeUsedIsRefusedByName) {
  const auto opening = [](const std::string& uri) { return [uri] { open(uri, all_sources()); }; };
  const Served server(listen("tcp://127.0.0.1:0", {}), source("builtin:two_mass.slow"));
  const Scratch folder;
  EXPECT_TRUE(
      refuses(ErrorCode::input_output, {server.address(), "in use"}, [&] { listen(server.address(), {}); }));
  EXPECT_TRUE(
      refuses(ErrorCode::input_output, {"tcp://127.0.0.1:1", "refused"}, opening("tcp://127.0.0.1:1")));
  EXPECT_TRUE(
      refuses(ErrorCode::input_output, {"none.invalid", "not known"}, opening("tcp://none.invalid:1")));
  EXPECT_TRUE(
      refuses(ErrorCode::input_output, {"unix:/none/socket", "No such file"}, opening("unix:/none/socket")));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"tcp:HOST", "of the form"}, opening("tcp:HOST")));
  EXPECT_TRUE(
      refuses(ErrorCode::invalid_argument, {"65536", "of the form"}, opening("tcp://localhost:65536")));
  EXPECT_TRUE(
      refuses(ErrorCode::not_supported, {"192.0.2.1", "--allow-plaintext"}, opening("tcp://192.0.2.1:1")));
  for (const std::string address : {"tcp://*:0", "tls://*:0"})
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {address, "0.0.0.0"}, [&] { listen(address, {}); }));
  EXPECT_TRUE(refuses(ErrorCode::not_supported, {"0.0.0.0", "--allow-plaintext"},
                      [] { listen("tcp://0.0.0.0:0", {}); }));
  EXPECT_TRUE(
      refuses(ErrorCode::invalid_argument, {"'deadline' is 0"}, opening(server.address() + "?deadline=0")));
}

TEST(Sockets, AFileLeftOfAServerThatIsGoneIsUsedAgain) {
  const Scratch folder;
  const std::string address = "unix:" + (folder.path() / "socket").string();
  const auto made = listen(address, {});
  std::filesystem::rename(folder.path() / "socket", folder.path() / "kept");
  { const auto another = listen(address, {}); }
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "socket")) << "a listener removes its file";
}

TEST(Sockets, MoreSessionsThanAllowedAreToldSo) {
  wire::ServerSettings one;
  one.most_sessions = 1;
  const Scratch folder;
  for (const std::string& address :
       {std::string("tcp://127.0.0.1:0"), "unix:" + (folder.path() / "socket").string()}) {
    const Served server(listen(address, {}), source("builtin:two_mass.slow"), one);
    const auto first = open(server.address(), all_sources());
    for (int k = 0; k < 20; ++k)  // whether the server closes before the request comes, or after
      EXPECT_TRUE(refuses(ErrorCode::not_supported, {server.address(), "1 sessions open"},
                          [&] { open(server.address(), all_sources()); }));
  }
}

/// Also where nothing can be sent any more, as on a Unix socket.
TEST(Sockets, AClientOfASessionThatEndedIdleIsToldSo) {
  wire::ServerSettings hasty;
  hasty.session.idle = 0.05;
  const Scratch folder;
  for (const std::string& address :
       {std::string("tcp://127.0.0.1:0"), "unix:" + (folder.path() / "socket").string()}) {
    const Served server(listen(address, {}), source("builtin:two_mass.slow"), hasty);
    const auto slow = open(server.address(), all_sources());
    const auto deadline = wire::in_seconds(30.0);
    while (server.log().size() < 2 && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
    std::vector<double> memory(static_cast<std::size_t>(slow->info().row_size()));
    Samples y(memory.data(), slow->info().row_size(), 1);
    const double u0 = 0.0;
    EXPECT_TRUE(refuses(ErrorCode::input_output,
                        {server.address(), "initialize", "no request came within 0.05 s"}, [&] {
                          slow->initialize(0.0, 1.0, {&u0, 1}, y);
                        }));
  }
}

TEST(Sockets, AServerThatEndsInARunEndsItWithAnErrorThatNamesSubsystemAddressAndTime) {
  auto server = std::make_unique<Served>(listen("tcp://127.0.0.1:0", {}), source("builtin:two_mass.both"));
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
