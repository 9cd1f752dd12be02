// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Exchanges with a server allocate nothing once the run has settled, on either side. Sockets only: OpenSSL
// allocates within itself for each record, libzmq for each message.
#include <gtest/gtest.h>

#include "counted_malloc.hpp"
#include "run_bench.hpp"
#include "scratch.hpp"
#include "served.hpp"
#include "this_process.hpp"

#if TANDEM_OWN_MALLOC
namespace tandem::test {
namespace {

/// Allocations of both sides in 5000 rounds of the two masses, the slow one from a server of its own: the end
/// of an earlier session would be counted too.
std::int64_t allocations_with(const std::string& address, const char* schedule) {
  const std::string ratio = "?frequency_ratio=30.7";
  const Served server(listen(address, {}), source("builtin:two_mass.slow"));
  const auto fast = open("builtin:two_mass.fast" + ratio, all_sources());
  const auto slow = open(server.address() + ratio, all_sources());
  RunBench bench;
  bench.add("fast", *fast).add("slow", *slow).schedule(schedule);
  bench.connect("slow.x2", "fast.x2", "lagrange3").connect("fast.x1", "slow.x1", "lagrange3");
  Coordinator& run = bench.make(1e9);
  run.initialize();
  for (int k = 0; k < 300; ++k) run.round();
  allocations = 0;
  counting = true;
  for (int k = 0; k < 5000; ++k) run.round();
  counting = false;
  return allocations;
}

void allocates_nothing(const std::string& address) {
  for (const char* schedule : {"slowest-first", "fastest-first", "parallel"})
    EXPECT_EQ(allocations_with(address, schedule), 0) << address << ", " << schedule;
}

TEST(NoAllocationOver, Sockets) {
  const Scratch folder;
  allocates_nothing("tcp://127.0.0.1:0");
  allocates_nothing("unix:" + (folder.path() / "socket").string());
}

TEST(Room, ThatAClientAsksForTakesNoMemoryBeforeItIsUsed) {
  const Served server(listen("tcp://127.0.0.1:0", {}), source("builtin:two_mass.slow"));
  const auto channel = connect(server.address(), {});
  wire::Writer frame;
  const auto ask = [&](wire::Type type, std::uint32_t number, const auto& put) {
    wire::begin(frame, type, number);
    put(frame);
    wire::finish(frame);
    channel->send(frame.bytes(), wire::in_seconds(30.0));
    return wire::Frame::read(channel->receive(wire::in_seconds(30.0)), wire::usual_longest).header.type;
  };
  EXPECT_EQ(
      ask(wire::Type::hello, 1, [](wire::Writer& w) { wire::put_hello(w, {.text = "frequency_ratio=25"}); }),
      wire::Type::hello);
  const std::int64_t before = resident();
  EXPECT_EQ(ask(wire::Type::initialize, 2,
                [](wire::Writer& w) {
                  wire::put_initialize(w, {0.0, 10.0, ~std::uint64_t{0}, {0.5}});
                }),
            wire::Type::samples);
  EXPECT_LT(resident() - before, 16 << 20) << "of the 64 MiB that a reply may have";
}

}  // namespace
}  // namespace tandem::test
#endif
