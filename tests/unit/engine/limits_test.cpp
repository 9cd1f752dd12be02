// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Signals that leave their limits, and parameters that are texts.
#include <gtest/gtest.h>

#include <cstdio>

#include "diagram_run.hpp"
#include "refusal.hpp"

namespace tandem::engine {
namespace {

using test::DiagramRun;
using test::refuses;

/// x = t^2 from 0 on; left at 0.5 s.
std::string parabola(const std::string& limit) {
  return "[parameters]\nleave = { value = 'warn', allowed = ['warn', 'stop'] }\n[blocks]\n"
         "x = { kind = 'product', inputs = ['time', 'time'] }\ny = { kind = 'integrator', input = 'x' }\n"
         "[outputs]\ny = { unit = '1' }\n[limits]\nhigh = { " +
         limit + " }\n";
}

std::vector<std::string> told(const std::string& text, double t, const IntegratorSettings& settings = {}) {
  std::vector<std::string> all;
  const Program program = compile(read_diagram("d", text));
  Simulation run(program, nullptr, make_integrator(settings),
                 {.tell = [&](const std::string& what) { all.push_back(what); }});
  for (int again = 0; again < 2; ++again) {
    run.start(0.0);
    while (run.time() < t) run.step(t);
  }
  return all;
}

TEST(Limits, AreToldOnceWhereTheyAreLeft) {
  for (const std::string& name : integrator_names()) {
    const auto all = told(parabola("signal = 'x', high = 0.25, sentence = 'why'"), 1.0, {.name = name});
    ASSERT_EQ(all.size(), 1U) << name;
    double t = 0.0;
    ASSERT_EQ(
        std::sscanf(all[0].c_str(), "limit 'high': signal 'x' is above 0.25 from t = %lf s on: why", &t), 1)
        << all[0];
    EXPECT_NEAR(t, 0.5, 1e-9) << name;
  }
}

TEST(Limits, EndTheRunOrAreIgnored) {
  const auto stop = parabola("signal = 'x', high = 0.25, on_leaving = 'stop', sentence = 'why'");
  EXPECT_TRUE(refuses(ErrorCode::numerical, {"limit 'high': signal 'x' is above 0.25", "0.50000000", "why"},
                      [&] { told(stop, 1.0); }));
  EXPECT_TRUE(told(stop, 0.49).empty());
  EXPECT_TRUE(
      told(parabola("signal = 'x', high = 0.25, on_leaving = 'ignore', sentence = 'why'"), 1.0).empty());
}

/// At the start; from the inputs of the first step, since before those are not known.
TEST(Limits, AreSeenWhereTheRunBeginsBeyondThem) {
  EXPECT_EQ(told(parabola("signal = 'x', low = 0.1, high = 2, sentence = 'why'"), 0.1).size(), 1U);
  EXPECT_TRUE(refuses(ErrorCode::numerical, {"below 0.1 from t = 0 s on"}, [] {
    told(parabola("signal = 'x', low = 0.1, on_leaving = 'stop', sentence = 'why'"), 0.1);
  }));
}

TEST(Limits, FollowATextThatIsAParameter) {
  const auto text = parabola("signal = 'x', high = 0.25, on_leaving = '$leave', sentence = 'why'");
  EXPECT_EQ(told(text, 1.0).size(), 1U);
  const Description d = read_diagram("d", text, {{"leave", "stop"}});
  EXPECT_EQ(d.limits[0].on_leaving, Limit::OnLeaving::stop);
  const auto code = ErrorCode::invalid_argument;
  EXPECT_TRUE(refuses(code, {"'leave' is 'no'", "warn, stop"}, [&] {
    read_diagram("d", text, {{"leave", "no"}});
  }));
  EXPECT_TRUE(refuses(code, {"'leave' is 1", "a text"}, [&] { read_diagram("d", text, {{"leave", 1.0}}); }));
}

TEST(Limits, AreRefusedByPlace) {
  const auto refused = [](const std::string& limit, const std::vector<std::string>& words) {
    return refuses(ErrorCode::invalid_argument, words, [&] { compile(read_diagram("d", parabola(limit))); });
  };
  EXPECT_TRUE(refused("signal = 'x', sentence = 'why'", {"d:9", "limits.high", "low"}));
  EXPECT_TRUE(refused("high = 1, sentence = 'why'", {"d:9", "signal"}));
  EXPECT_TRUE(refused("signal = 'x', high = 1", {"d:9", "sentence"}));
  EXPECT_TRUE(refused("signal = 'z', high = 1, sentence = 'why'", {"d:9", "'z'"}));
  EXPECT_TRUE(
      refused("signal = 'x', high = 1, low = 1, sentence = 'why'", {"d:9", "low is 1", "below high, 1"}));
  EXPECT_TRUE(
      refused("signal = 'x', high = 1, on_leaving = 'end', sentence = 'why'", {"d:9", "'end'", "stop"}));
  EXPECT_TRUE(refused("signal = 'x', high = '$leave', sentence = 'why'", {"d:9", "high", "a number"}));
}

/// One that starts where another does, which starts where a switch leads.
TEST(Start, FollowsSignalsThroughSwitchesAndOtherStarts) {
  DiagramRun run(
      "[blocks]\nlevel = { kind = 'switch', control = 2, above = 5, below = 1 }\n"
      "x = { kind = 'integrator', input = 0, initial = 'level' }\ny = { kind = 'integrator', input = 0, "
      "initial = "
      "'twice' }\ntwice = { kind = 'gain', input = 'x', gain = 2 }\n[outputs]\ny = { unit = '1' }\n");
  EXPECT_EQ(run.run(0.1, 1).output(0), 10.0);
}

}  // namespace
}  // namespace tandem::engine
