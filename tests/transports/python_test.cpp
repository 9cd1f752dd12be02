// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Python on either side.
#include "python.hpp"

#include <gtest/gtest.h>

#include "child.hpp"
#include "refusal.hpp"
#include "run_bench.hpp"
#include "same_bits.hpp"
#include "scratch.hpp"
#include "served.hpp"
#include "tandem/fixed_step.hpp"

namespace tandem::test {
namespace {

std::vector<Recording::Rows> two_masses(const std::string& slow_uri) {
  const auto fast = open("builtin:two_mass.fast?frequency_ratio=30.7", all_sources());
  const auto slow = open(slow_uri, all_sources());
  RunBench bench;
  bench.add("fast", *fast).add("slow", *slow);
  bench.connect("slow.x2", "fast.x2", "lagrange3").connect("fast.x1", "slow.x1", "lagrange3");
  return bench.run(20.0).all();
}

TEST(Python, TwoMassesWithMass2InPythonGiveTheSameBits) {
  EXPECT_TRUE(
      same_bits(two_masses(python_mass2(30.7)), two_masses("builtin:two_mass.slow?frequency_ratio=30.7")));
}

/// integral.py in C++.
class Integral {
 public:
  SubsystemInfo info() const { return {"integral", {{"u", "m/s"}}, {{"x", "m"}}, {}, {}}; }
  double own_step() const { return 0.1; }
  void start(double, std::span<const double>) { x_ = 0.0; }
  void step(const OwnStep& s, std::span<const Signal> u) {
    x_ += s.length * (u[0].value(s.begin) + u[0].value(s.end)) / 2.0;
  }
  void outputs(double* y) const { *y = x_; }

 private:
  double x_ = 0.0;
};

/// Its input jumps at 0.23 s from a line to a parabola, and at 0.27 s to a line; the rest is a kink at 0.5 s.
std::vector<double> integral_of_jumps(Subsystem& integral) {
  Segment pieces[] = {{0.23, 0.0, {1.0, 0.3}},
                      {0.27, 0.23, {-2.0, 0.7, 5.0}},
                      {0.5, 0.27, {1.5, -0.4}},
                      {9.0, 0.5, {1.408, 2.0}}};
  for (const int k : {1, 2}) mark_jump(pieces[k], true);
  const Signal u(pieces, 4, 2);
  std::vector<double> rows(3 * 20), u0{1.0};
  Samples y(rows.data(), 3, 20);
  integral.initialize(0.0, 2.0, u0, y);
  integral.advance(0.25, true, {&u, 1}, y);
  integral.advance(1.0, false, {&u, 1}, y);
  return rows;
}

TEST(Python, StepsAreSplitWhereAnInputJumps) {
  FixedStep<Integral> here{Integral()};
  const auto there =
      open("spawn:" + python_program("integral.py", TANDEM_SOURCE_DIR "/tests/programs/"), all_sources());
  const auto expected = integral_of_jumps(here);
  EXPECT_EQ(integral_of_jumps(*there), expected);
  const double exact = 0.23 + 0.15 * 0.23 * 0.23 - 2.0 * 0.04 + 0.35 * 0.04 * 0.04 +
                       5.0 / 3.0 * 0.04 * 0.04 * 0.04 + 1.5 * 0.03 - 0.2 * 0.03 * 0.03;
  EXPECT_NEAR(expected[3 * 4 + 2], exact, 2e-5) << "the rule's error in the parabola is 1.3e-5";
}

/// follower.py in C++.
class Follower {
 public:
  SubsystemInfo info() const { return {"follower", {{"u", "m/s"}}, {{"x", "m"}}, {{0, 0}}, {}}; }
  double own_step() const { return 0.1; }
  void start(double, std::span<const double> u0) { x_ = 0.0, u_ = u0[0]; }
  void step(const OwnStep& s, std::span<const Signal> u) {
    u_ = u[0].value(s.end);
    x_ += s.length * (u[0].value(s.begin) + u_) / 2.0;
  }
  bool jump(double t, std::span<const Signal> u) {
    const double before = std::exchange(u_, u[0].value(t));
    return u_ != before;
  }
  void outputs(double* y) const { *y = x_ + u_; }

 private:
  double x_ = 0.0, u_ = 0.0;
};

/// Where a call begins, where a step of it ends, and between nodes, from which no row comes.
TEST(Python, OutputsThatJumpWithAnInputGiveASecondRow) {
  Segment pieces[] = {{0.2, 0.0, {1.0, 0.3}}, {0.4, 0.2, {-2.0}}, {0.53, 0.4, {3.0}}, {9.0, 0.53, {1.0}}};
  for (const int k : {1, 2, 3}) mark_jump(pieces[k], true);
  const Signal u(pieces, 4, 2), later(pieces + 1, 3, 2);
  FixedStep<Follower> here{Follower()};
  const auto there =
      open("spawn:" + python_program("follower.py", TANDEM_SOURCE_DIR "/tests/programs/"), all_sources());
  std::vector<double> rows[2];
  for (Subsystem* one : {static_cast<Subsystem*>(&here), there.get()}) {
    auto& memory = rows[one == &here];
    memory.resize(3 * 20);
    Samples y(memory.data(), 3, 20);
    const double u0 = 1.0;
    one->initialize(0.0, 2.0, {&u0, 1}, y);
    one->advance(0.2, true, {&u, 1}, y);
    one->advance(1.0, false, {&later, 1}, y);
  }
  EXPECT_EQ(rows[0], rows[1]);
  std::vector<double> marked;
  for (std::size_t k = 0; k < 20; ++k)
    if (rows[0][3 * k + 1] == 1.0) marked.push_back(rows[0][3 * k]);
  EXPECT_EQ(marked, (std::vector<double>{0.2, 0.4}));
}

TEST(Python, AnExceptionOfTheModelIsOneSentence) {
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"mass2.py", "hello", "parameter 'k' is needed"},
                      [] { open("spawn:" + python_program("mass2.py") + "?m=1", all_sources()); }));
}

TEST(Python, DrivesASubsystemAsItsMasterAndGetsTheSameBits) {
  const Served server(listen("tcp://127.0.0.1:0", {}), source("builtin:two_mass.slow"));
  Child master(
      {"sh", "-c", python_program("master.py") + " '" + server.address() + "' '" + mass2_parameters() + "'"});
  EXPECT_EQ(master.status(), 0);
}

/// Sentences of connect() to what is not right; a program that it has started goes with the error.
TEST(Python, AsTheMasterItRefusesWhatIsNotRightInOneSentence) {
  const Served server(listen("tcp://127.0.0.1:0", {}), source("builtin:two_mass.slow"));
  Child master({"sh", "-c",
                "exec " + python_program("refusals.py", TANDEM_SOURCE_DIR "/tests/programs/") + " '" +
                    server.address() + "' 'spawn:" TANDEM_COMMAND " serve builtin:two_mass.slow'"});
  EXPECT_EQ(master.status(), 0);
}

/// Its socket's file goes with it, and what a killed one left is replaced.
TEST(Python, AServerListensOnThisMachineOnlyAndLeavesNothing) {
  const auto server = [](const std::string& address) {
    return std::vector<std::string>{"sh", "-c",
                                    "exec " + python_program("mass2.py") + " --listen '" + address + "'"};
  };
  for (const std::string address : {"tcp://0.0.0.0:0", "nonsense", "unix:/none/socket"})
    EXPECT_EQ(Child(server(address)).status(), 2) << address;
  const Scratch folder;
  const std::string path = (folder.path() / "socket").string();
  for (const int signal : {SIGKILL, SIGTERM}) {
    Child python(server("unix:" + path));
    EXPECT_EQ(python.word_after(" at "), "unix:" + path);
    python.signal(signal);
    EXPECT_EQ(python.status(), signal == SIGKILL ? -SIGKILL : 0);
    EXPECT_EQ(std::filesystem::exists(path), signal == SIGKILL);
  }
}

TEST(Python, OnceEndsAfterASessionThatIsNoPortScan) {
  Child server({"sh", "-c", "exec " + python_program("mass2.py") + " --once --listen tcp://127.0.0.1:0"});
  const std::string address = server.word_after(" at ");
  scan_ports(address);
  { const auto session = open(address + "?" + mass2_parameters(), all_sources()); }
  EXPECT_EQ(server.status(), 0);
}

TEST(Python, AFunctionHandedToScipyFollowsItsExactSolution) {
#ifdef TANDEM_PYTHON_SCIPY
  const auto heat = open("spawn:" + python_program("heat.py") + "?h=0.1", all_sources());
  RunBench bench;
  bench.add("heat", *heat).topology.set_start("heat.surroundings", 300.0);
  const auto rows = bench.run(1.0).all()[0];
  ASSERT_EQ(rows.size(), 11U);
  // T = 300 + 100 exp(-t); relative tolerance 1e-9 of SciPy, of a value of about 400, over ten steps.
  for (const auto& row : rows) EXPECT_NEAR(row[2], 300.0 + 100.0 * std::exp(-row[0]), 10 * 4e-7);
#else
  GTEST_SKIP() << "SciPy is absent (package python3-scipy)";
#endif
}

}  // namespace
}  // namespace tandem::test
