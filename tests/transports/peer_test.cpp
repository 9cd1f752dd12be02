// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// C on either side.
#include "tandem/peer.h"

#include <gtest/gtest.h>

#include <sstream>

#include "mass2_library.hpp"
#include "peers.hpp"
#include "refusal.hpp"
#include "run_bench.hpp"
#include "same_bits.hpp"
#include "scratch.hpp"
#include "scripted.hpp"
#include "served.hpp"
#include "tandem/c_subsystem.hpp"

namespace tandem::test {
namespace {

std::vector<Recording::Rows> masses_with(const std::string& slow_uri) {
  const auto fast = open("builtin:two_mass.fast?frequency_ratio=30.7", all_sources());
  const auto slow = open(slow_uri, all_sources());
  RunBench bench;
  bench.add("fast", *fast).add("slow", *slow);
  bench.connect("slow.x2", "fast.x2", "lagrange3").connect("fast.x1", "slow.x1", "lagrange3");
  return bench.run(20.0).all();
}

TEST(Peer, TwoMassesWithMass2InCGiveTheSameBits) {
  const Scratch folder;
  const auto builtin = masses_with("builtin:two_mass.slow?frequency_ratio=30.7");
  EXPECT_TRUE(same_bits(masses_with("spawn:" + c_mass2() + "?" + mass2_parameters(30.7)), builtin));
  for (const std::string& address :
       {std::string("tcp://127.0.0.1:0"), "unix:" + (folder.path() / "socket").string()}) {
    const PeerServer server({c_mass2()}, address);
    EXPECT_TRUE(same_bits(masses_with(server.address() + "?" + mass2_parameters(30.7)), builtin));
  }
}

#if TANDEM_FORTRAN
TEST(Peer, TwoMassesWithMass2InFortranGiveTheSameBits) {
  EXPECT_TRUE(same_bits(
      masses_with("spawn:" TANDEM_EXAMPLES "/example_mass2_server_fortran?" + mass2_parameters(30.7)),
      masses_with("builtin:two_mass.slow?frequency_ratio=30.7")));
}
#endif

TEST(Peer, DrivesASubsystemAsItsMasterAndGetsTheSameBits) {
  const Served server(listen("tcp://127.0.0.1:0", {}), source("builtin:two_mass.slow"));
  Child master({TANDEM_EXAMPLES "/example_master_c", server.address(), mass2_parameters()});
  EXPECT_EQ(master.status(), 0);
  Child other({TANDEM_EXAMPLES "/example_master_c", server.address(), mass2_parameters(31.0)});
  EXPECT_EQ(other.status(), 1);
}

TEST(Peer, AnErrorOfTheSubsystemHasItsCodeAndSentence) {
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"hello", "no parameter 'colour=blue'"},
                      [] { open("spawn:" + oscillator_server() + "?colour=blue", all_sources()); }));
}

TEST(Peer, SeveralSessionsAtOnceAndEachHasAnInstanceOfItsOwn) {
  const PeerServer server({oscillator_server()}, "tcp://127.0.0.1:0");
  const auto a = open(server.address() + "?h=0.1", all_sources());
  const auto b = open(server.address() + "?h=0.3", all_sources());
  std::vector<double> row(static_cast<std::size_t>(a->info().row_size()));
  const std::vector<double> u0 = {0.0};
  for (const auto& [who, next] : {std::pair{a.get(), 0.1}, std::pair{b.get(), 0.3}}) {
    Samples y(row.data(), who->info().row_size(), 1);
    EXPECT_EQ(who->initialize(0.0, 1.0, u0, y).next_time, next);
  }
}

TEST(Peer, ServesOnceAndEndsOnSigterm) {
  Child once({oscillator_server(), "--once", "--listen", "tcp://127.0.0.1:0"});
  const std::string address = once.word_after(" at ");
  scan_ports(address);
  { const auto session = open(address, all_sources()); }
  EXPECT_EQ(once.status(), 0);
  const Scratch folder;
  const std::string file = (folder.path() / "socket").string();
  Child server({oscillator_server(), "--listen", "unix:" + file});
  const auto session = open(server.word_after(" at "), all_sources());  // an open one does not keep it
  server.signal(SIGTERM);
  EXPECT_EQ(server.status(), 0);
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(Peer, RefusesWhatIsNotRightBeforeItListens) {
  const auto status = [](std::vector<std::string> words) {
    words.insert(words.begin(), oscillator_server());
    return Child(words).status();
  };
  EXPECT_EQ(status({}), 2);
  EXPECT_EQ(status({"--listen", "tcp://0.0.0.0:0"}), 2);
  EXPECT_EQ(status({"--listen", "tcp://*:0", "--once"}), 2);
  EXPECT_EQ(status({"--listen", "nonsense"}), 2);
  EXPECT_EQ(status({"--listen", "tcp://127.0.0.1:0", "--deadline", "0"}), 2);
  EXPECT_EQ(status({"--listen", "tcp://127.0.0.1:0", "--sessions", "1.5"}), 2);
  EXPECT_EQ(status({"--colour"}), 2);
}

auto calling(const std::string& uri) {
  return [uri] { CSubsystem(tandem_remote(), uri); };
}

TEST(Peer, AsTheClientItRefusesWhatIsNotRight) {
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'nonsense'", "tcp://HOST:PORT"}, calling("nonsense")));
  EXPECT_TRUE(refuses(ErrorCode::not_supported, {"192.0.2.1", "plain text"}, calling("tcp://192.0.2.1:1")));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'*'", "0.0.0.0"}, calling("tcp://*:1")));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"deadline"}, calling("tcp://127.0.0.1:1?deadline=soon")));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"108"}, calling("unix:/" + std::string(107, 'x'))));
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"unix:/none", "No such file"}, calling("unix:/none")));
  EXPECT_TRUE(refuses(ErrorCode::input_output,
                      {"spawn:no_such_program, hello: program 'no_such_program' ended with status 127"},
                      calling("spawn:no_such_program")));
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"spawn:sleep 60", "deadline of 0.2 s"},
                      calling("spawn:sleep 60?deadline=0.2")));
}

TEST(Peer, AsTheClientItTakesAJumpThatRepeatsATimeAndNoOtherRowThatDoes) {
  for (const bool jump : {true, false}) {
    const Served server(listen("tcp://127.0.0.1:0", {}), [jump](const std::string&) {
      auto made = std::make_unique<Scripted>(mirror(0.1));
      made->instead_of_advance = [jump, &s = *made](double, bool, std::span<const Signal> u, Samples& y) {
        s.grid().step();
        s.put(u, y);
        s.put(u, y, jump);
        return s.clock(Stop::event);
      };
      return made;
    });
    CSubsystem far(tandem_remote(), server.address());
    RunBench bench;
    bench.add("far", far).topology.set_start("far.u", 0.0);
    if (jump)
      EXPECT_EQ(bench.run(1.0).all()[0].size(), 21U);
    else
      EXPECT_TRUE(refuses(ErrorCode::numerical,
                          {"advance at t = 0 s", "a sample at t = 0.1 s that does not come after t = 0.1 s"},
                          [&] { bench.run(1.0); }));
  }
}

TEST(Peer, EndsTheProgramThatItHasStartedAndWhatThatHasLeft) {
  const Scratch folder;
  const std::string file = (folder.path() / "processes").string();
  pid_t process = 0, left = 0;
  {
    const CSubsystem s(tandem_remote(), "spawn:sh -c 'sleep 1000 & echo $$ $! > " + file + "; exec " +
                                            oscillator_server() + "'?deadline=4&h=0.1");
    std::istringstream(read_text(file)) >> process >> left;
    EXPECT_FALSE(is_gone(process) || is_gone(left));
  }
  EXPECT_TRUE(is_gone(process));
  EXPECT_TRUE(ends(left));
}

}  // namespace
}  // namespace tandem::test
