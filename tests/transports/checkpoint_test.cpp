// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A run that is cut goes on to the same last bit, wherever its subsystems live.
#include <gtest/gtest.h>

#include "curve_pair.hpp"
#include "cut_run.hpp"
#include "peers.hpp"
#include "python.hpp"
#include "refusal.hpp"
#include "scratch.hpp"
#include "served.hpp"
#include "tandem/wire/messages.hpp"
#include "tls_pair.hpp"

namespace tandem::test {
namespace {

constexpr const char* same_ratio = "frequency_ratio=30.7";

/// Mass 1 here, mass 2 from that source.
struct CutMasses {
  explicit CutMasses(const std::string& slow_uri)
      : fast(open("builtin:two_mass.fast?frequency_ratio=30.7", all_sources())),
        slow(open(slow_uri, all_sources())) {
    bench.add("fast", *fast).add("slow", *slow);
    bench.connect("slow.x2", "fast.x2", "lagrange3").connect("fast.x1", "slow.x1", "lagrange3");
  }
  std::unique_ptr<Subsystem> fast, slow;
  RunBench bench;
};

void goes_on_over(const std::string& uri) {
  CutMasses here(std::string("builtin:two_mass.slow?") + same_ratio);
  const auto expected = here.bench.run(4.0).all();
  for (int cut = 0; cut < 30; cut += 5) {
    CutMasses before(uri), after(uri);
    EXPECT_TRUE(same_bits(cut_after(cut, before.bench, after.bench, {0.0, 4.0}), expected))
        << uri << ", cut after round " << cut;
  }
}

std::string with_parameters(const std::string& address) { return address + "?" + same_ratio; }

TEST(CheckpointOver, Libraries) {
  for (const char* language : {"c", "cpp"}) goes_on_over(mass2_library(language) + mass2_parameters(30.7));
}

TEST(CheckpointOver, Sockets) {
  const Scratch folder;
  for (const std::string& address :
       {std::string("tcp://127.0.0.1:0"), "unix:" + (folder.path() / "socket").string()}) {
    const Served server(listen(address, {}), source("builtin:two_mass.slow"));
    goes_on_over(with_parameters(server.address()));
  }
}

TEST(CheckpointOver, SpawnedPrograms) {
  goes_on_over(with_parameters("spawn:" TANDEM_COMMAND " serve builtin:two_mass.slow"));
  goes_on_over(python_mass2(30.7));
}

TEST(CheckpointOver, ServersInC) {
  const Scratch folder;
  goes_on_over("spawn:" + c_mass2() + "?" + mass2_parameters(30.7));
  for (const std::string& address :
       {std::string("tcp://127.0.0.1:0"), "unix:" + (folder.path() / "socket").string()}) {
    const PeerServer server({c_mass2()}, address);
    goes_on_over(server.address() + "?" + mass2_parameters(30.7));
  }
}

#if TANDEM_HAS_TLS
TEST(CheckpointOver, Tls) {
  const TlsFolder keys;
  const Served server(listen("tls://127.0.0.1:0", keys.settings()), source("builtin:two_mass.slow"));
  goes_on_over(with_parameters(server.address()) + "&" + keys.query());
}
#endif

#if TANDEM_HAS_ZEROMQ
TEST(CheckpointOver, ZeroMqWithKeys) {
  const CurveFolder keys;
  const Served server(zmq_listen("tcp://127.0.0.1:0", keys.settings()), source("builtin:two_mass.slow"));
  goes_on_over(with_parameters(server.address()) + "&" + keys.query());
}

TEST(CheckpointOver, ZeroMq) {
  const Scratch folder;
  for (const std::string& address : {std::string("tcp://127.0.0.1:0"), std::string("inproc://cut"),
                                     "ipc://" + (folder.path() / "socket").string()}) {
    const Served server(zmq_listen(address, {}), source("builtin:two_mass.slow"));
    goes_on_over(with_parameters(server.address()));
  }
}
#endif

TEST(CheckpointOver, AStateOfAnotherIsRefusedAndTheConnectionGoesOn) {
  const Served server(listen("tcp://127.0.0.1:0", {}), source("builtin:two_mass.slow"));
  const auto slow = open(with_parameters(server.address()), all_sources());
  std::vector<double> memory(static_cast<std::size_t>(slow->info().row_size()));
  Samples y(memory.data(), slow->info().row_size(), 1);
  const double u0 = 0.0;
  slow->initialize(0.0, 1.0, {&u0, 1}, y);
  const auto bytes = slow->serialize_state(slow->save_state());
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {server.address(), "deserialize", "ends after"}, [&] {
    slow->deserialize_state({bytes.data(), bytes.size() - 1});
  }));
  EXPECT_NO_THROW(slow->restore_state(slow->deserialize_state(bytes)));
}

}  // namespace
}  // namespace tandem::test
