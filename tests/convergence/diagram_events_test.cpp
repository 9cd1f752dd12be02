// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The order of a fixed step across events, against exact motions.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <vector>

#include "diagram_run.hpp"

namespace tandem::engine {
namespace {

using test::DiagramRun;

/// log2 of the ratio of errors with so many steps and twice as many.
double order(const std::string& text, double t, double exact, int steps,
             const IntegratorSettings& settings = {}) {
  const auto error = [&](int count) {
    DiagramRun run(text, settings);
    return std::abs(run.run(t, count).output(0) - exact);
  };
  return std::log2(error(steps) / error(2 * steps));
}

const std::string oscillator =
    "[blocks]\nx = { kind = 'integrator', input = 'v', initial = 1 }\nv = { kind = 'integrator', input = 'a' "
    "}\n"
    "a = { kind = 'gain', input = 'x', gain = -1 }\n[outputs]\nx = { unit = 'm' }\n";

TEST(DiagramOrder, IsFourOnAnOscillator) {
  EXPECT_NEAR(order(oscillator, 5.0, std::cos(5.0), 100), 4.0, 0.2);
}

/// x' = 1 up to x = 1/2, from there x' = 2 - x.
const std::string kink =
    "[blocks]\nx = { kind = 'integrator', input = 'rate' }\npull = { kind = 'gain', input = 'x', gain = -1, "
    "offset = 2 }\n"
    "rate = { kind = 'switch', control = 'x', threshold = 0.5, above = 'pull', below = 1 }\n[outputs]\nx = { "
    "unit = '1' }\n";
const double after_kink = 2.0 - 1.5 * std::exp(-1.7);  // at t = 2.2, 1.7 after x = 1/2

TEST(DiagramOrder, IsKeptAcrossASwitch) { EXPECT_NEAR(order(kink, 2.2, after_kink, 23), 4.0, 0.2); }

/// Seen at the end of a step, the switch comes late by a part of it.
TEST(DiagramOrder, IsOneWhereEventsAreNotLocated) {
  DiagramRun coarse(kink, {"rk4", false}), fine(kink, {"rk4", false});
  const double first = std::abs(coarse.run(2.2, 23).output(0) - after_kink),
               second = std::abs(fine.run(2.2, 230).output(0) - after_kink);
  EXPECT_GT(first, 1e-3);
  EXPECT_LT(second, 0.3 * first);
  EXPECT_GT(second, 1e-5);
}

/// A ball that falls from 1 m with g = 2 and has its velocity set to 0.8 of what it was, upwards, at each
/// bounce.
TEST(DiagramOrder, BouncesAreWhereTheyShouldBe) {
  DiagramRun ball(
      "[blocks]\nx = { kind = 'integrator', input = 'v', initial = 1 }\n"
      "v = { kind = 'integrator', input = -2, reset = 'below', reset_to = 'up' }\n"
      "below = { kind = 'gain', input = 'x', gain = -1 }\nup = { kind = 'gain', input = 'v', gain = -0.8 }\n"
      "[outputs]\nx = { unit = 'm' }\nv = { unit = 'm/s' }\n");
  // Down in 1 s with 2 m/s, up and down again in 1.6 s, then for 0.4 s up from 0.64 * 2 m/s.
  ball.run(3.0, 100);
  EXPECT_NEAR(ball.simulation.output(1), 2.0 * 0.64 - 2.0 * 0.4, 1e-11);
  EXPECT_NEAR(ball.simulation.output(0), 0.4 * (2.0 * 0.64 - 0.4), 1e-11);
}

/// A roof of straight lines, a sample every 0.31 s, a step: polynomials between instants, of which the method
/// makes no error.
TEST(DiagramOrder, SourcesWithKinksAreIntegratedExactly) {
  DiagramRun run(
      "[blocks]\nu = { kind = 'piecewise_linear', times = [0, 0.31, 1.0], values = [0, 3.1, 0] }\n"
      "x = { kind = 'integrator', input = 'u' }\nseen = { kind = 'sample', input = 'x', period = 0.31 }\n"
      "late = { kind = 'step', time = 0.77, after = 4 }\ny = { kind = 'integrator', input = 'late' }\n"
      "[outputs]\nx = { unit = '1' }\nseen = { unit = '1' }\ny = { unit = '1' }\n");
  run.run(1.2, 7);
  EXPECT_NEAR(run.simulation.output(0), 0.5 * 3.1, 1e-14);
  const double left = 1.0 - 0.93;  // at 0.93 s, the last sample
  EXPECT_NEAR(run.simulation.output(1), 0.5 * 3.1 - 0.5 * left * left * 3.1 / 0.69, 1e-14);
  EXPECT_NEAR(run.simulation.output(2), 4.0 * (1.2 - 0.77), 1e-11);
}

/// The engine open loop for 10 s, its throttle and load as blocks: the largest error of its speed [rad/s] at
/// each 10 ms, against steps of 0.1 ms.
class OpenLoopEngine {
 public:
  OpenLoopEngine() : program_(compile(diagram())), reference_(speeds(1e-4, true)) {}

  double error(double step, bool locate_events) const {
    const auto run = speeds(step, locate_events);
    double most = 0.0;
    for (std::size_t k = 0; k < run.size(); ++k) most = std::max(most, std::abs(run[k] - reference_[k]));
    return most;
  }

 private:
  static Description diagram() {
    Description d = read_diagram(std::filesystem::path(TANDEM_SOURCE_DIR "/scenarios/engine/engine.toml"));
    d.inputs.clear();
    d.blocks.push_back({"throttle", "step", {{"time", 5.0}, {"before", 8.97}, {"after", 11.93}}});
    d.blocks.push_back({"less", "step", {{"time", 2.0}, {"before", 25.0}, {"after", 20.0}}});
    d.blocks.push_back({"more", "step", {{"time", 8.0}, {"after", 5.0}}});
    d.blocks.push_back({"load", "sum", {{"inputs", std::vector<Wire>{"less", "more"}}}});
    return d;
  }

  std::vector<double> speeds(double step, bool locate_events) const {
    Simulation s(program_, nullptr, make_integrator({.name = "rk4", .locate_events = locate_events}));
    s.start(0.0);
    const long steps = std::lround(10.0 / step), each = std::lround(0.01 / step);
    std::vector<double> all;
    for (long k = 1; k <= steps; ++k) {
      s.run(static_cast<double>(k) * step);
      if (k % each == 0) all.push_back(s.output(0));
    }
    return all;
  }

  Program program_;
  std::vector<double> reference_;
};

/// Its charges are taken at events of the crank: seen at the end of a step, each is late by a part of it.
TEST(DiagramOrder, OfTheEngineTakesLocatedEvents) {
  const OpenLoopEngine engine;
  const double located = engine.error(1e-3, true), coarse = engine.error(2e-3, true);
  const double held = engine.error(1e-3, false);
  EXPECT_NEAR(std::log2(coarse / located), 4.0, 0.2);
  EXPECT_LT(located, 1e-3 * held);
  EXPECT_GT(held, 0.1);
}

}  // namespace
}  // namespace tandem::engine
