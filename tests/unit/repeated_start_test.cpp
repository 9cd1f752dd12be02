// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// When a start made by repetition is used, and what is told of it.
#include <gtest/gtest.h>

#include "relay_scene.hpp"
#include "run_bench.hpp"
#include "same_bits.hpp"
#include "scripted.hpp"
#include "two_mass/experiment.hpp"

namespace tandem {
namespace {

using test::RunBench;
using test::Scripted;

bool tells(const Coordinator& run, const std::string& words) {
  return std::any_of(run.notes().begin(), run.notes().end(),
                     [&](const std::string& note) { return note.find(words) != std::string::npos; });
}

/// Its output is cos(t) + gain u as of the end of each own step; no feedthrough is declared, so each pass
/// multiplies an error of the input by the gain.
Scripted amplifier(double gain) {
  return {
      {"amplifier", {{"u", "1"}}, {{"y", "1"}}, {}, {.restarts = true}},
      0.1,
      [gain](double t, const auto& u, double* y) { y[0] = std::cos(t) + gain * (t == 0.0 ? 0.0 : u[0]); }};
}

class RepeatedStart : public testing::Test {
 protected:
  std::vector<test::Recording::Rows> run(double gain, StartKind start = StartKind::automatic) {
    a = amplifier(gain), b = amplifier(gain);
    bench = {};
    bench.add("a", a).add("b", b).connect("a.y", "b.u", "lagrange3").connect("b.y", "a.u", "lagrange3");
    bench.coordination.order = {"a", "b"};
    bench.coordination.start = start;
    return bench.run(2.0).all();
  }
  const Coordinator& coordinator() const { return *bench.coordinator; }

  Scripted a = amplifier(0.0), b = amplifier(0.0);
  RunBench bench;
};

TEST_F(RepeatedStart, IsUsedWhereItsPassesSettle) {
  run(0.2);
  EXPECT_EQ(coordinator().start(), StartKind::repeat);
  EXPECT_FALSE(tells(coordinator(), "cold start"));
}

TEST_F(RepeatedStart, IsColdWithANoteWhereTheyDoNot) {
  for (const StartKind asked : {StartKind::automatic, StartKind::repeat}) {
    const auto cold = run(0.9, StartKind::cold);
    EXPECT_TRUE(test::same_bits(run(0.9, asked), cold));
    EXPECT_EQ(coordinator().start(), StartKind::cold);
    EXPECT_TRUE(tells(coordinator(), "cold start: the passes of a repeated start do not settle"));
  }
}

// Each of the four passes makes four own steps, one a call.
TEST_F(RepeatedStart, IsCountedApartFromExchangesAndSteps) {
  for (const double gain : {0.2, 0.9}) {
    run(gain);
    EXPECT_EQ(coordinator().start_passes(), 4);
    EXPECT_EQ(coordinator().effort(0).start_steps, 16);
    EXPECT_EQ(coordinator().effort(0).exchanges, static_cast<std::int64_t>(a.calls.size()) - 16);
    EXPECT_EQ(coordinator().effort(0).steps, gain < 0.5 ? 16 : 20);
  }
  run(0.2, StartKind::cold);
  EXPECT_EQ(coordinator().start_passes(), 0);
  EXPECT_EQ(coordinator().effort(0).start_steps, 0);
}

// x = 5 t^2 passes 0.1 m at 0.14 s, within the four steps of 50 ms.
TEST(RepeatedStartOfARelay, IsColdWithANoteWhereItSwitchesInTheFirstSteps) {
  test::RelayRun what;
  what.relay_step = what.plant_step = 0.05;
  what.order = {"relay", "plant"};
  test::RelayBench cold(what), automatic(what);
  cold.bench.coordination.start = StartKind::cold;
  const auto expected = cold.run();
  EXPECT_TRUE(test::same_bits(automatic.run(), expected));
  EXPECT_TRUE(tells(*automatic.bench.coordinator, "cold start: an output jumps within the first steps"));
  what.relay_step = what.plant_step = 0.02;
  test::RelayBench later(what);
  later.run();
  EXPECT_EQ(later.bench.coordinator->start(), StartKind::repeat);
}

// x passes 0.16 m at 0.187 s, after the relay's last own node within the four steps of 50 ms and before the
// plant's. A switching that the plant had passed there was seen 50 ms later, whoever led.
TEST(RepeatedStartOfARelay, IsColdTooWhereItSwitchesAfterItsLastNodeInThem) {
  for (const std::vector<std::string>& order :
       {std::vector<std::string>{"relay", "plant"}, {"plant", "relay"}}) {
    test::RelayRun what;
    what.system.width = 0.16;
    what.relay_step = 0.035, what.plant_step = 0.05;
    what.order = order;
    test::RelayBench cold(what), automatic(what);
    cold.bench.coordination.start = StartKind::cold;
    const auto expected = cold.run();
    EXPECT_TRUE(test::same_bits(automatic.run(), expected));
    EXPECT_TRUE(tells(*automatic.bench.coordinator, "cold start: an output jumps within the first steps"));
  }
}

// 0.153 with the repeated start, which ends far from what is repeated there.
TEST(RepeatedStartOfTwoMasses, IsLeftWhereTheSlowStepGoesOverMostOfAFastCycle) {
  const auto outcome =
      two_mass::run_case({.scheme = {"fastest-first", "lagrange4", "lagrange4"}, .frequency_ratio = 70.0});
  EXPECT_LT(outcome.figures.position_error.value(), 0.07);
}

}  // namespace
}  // namespace tandem
