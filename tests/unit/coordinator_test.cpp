// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/coordinator.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "polynomial.hpp"
#include "run_bench.hpp"
#include "scripted.hpp"
#include "word.hpp"

namespace tandem {
namespace {

using test::Polynomial;
using test::RunBench;
using test::Scripted;

const Polynomial cubic = Polynomial::of_degree(3);

/// Gives the cubic with all its derivatives, so that seeds are exact, and listens to one input.
Scripted cubic_source(double own_step, Abilities abilities = {}) {
  return {{"cubic", {{"u", "1"}}, {{"y", "1", 1, 3}}, {}, abilities},
          own_step,
          [](double t, const auto&, double* y) {
            Polynomial p = cubic;
            for (int k = 0; k <= 3; ++k, p = p.derivative()) y[k] = p(t);
          }};
}

/// Output "y" is what it reads at its own nodes.
Scripted reader(double own_step, Abilities abilities = {}) {
  SubsystemInfo info = test::mirror(own_step).info();
  info.abilities = abilities;
  return {info, own_step, [](double, const auto& u, double* y) { y[0] = u[0]; }};
}

/// The reader's samples are the cubic. Its values are below 4e3 up to t = 12; where the reader leads with 31
/// of the source's steps, the Lebesgue function of the extrapolation is below 4e4, so rounding is below 40
/// eps 4e3 4e4.
void expect_cubic(const test::Recording& r, int who) {
  for (std::size_t row = 0; row < r.rows(who).size(); ++row)
    ASSERT_NEAR(r.value(who, row), cubic(r.time(who, row)), 1.5e-6) << "at " << r.time(who, row);
}

class EachSchedule : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Schedules, EachSchedule,
                         testing::Values("slowest-first", "fastest-first", "parallel"),
                         [](const auto& p) { return test::word(p.param); });

TEST_P(EachSchedule, CarriesACubicExactlyAtAnyRatio) {
  for (const double ratio : {1.0, 3.0, 2.5, 30.7, std::sqrt(2.0), 0.4, 1.0 / 30.7}) {
    Scripted source = cubic_source(0.1 * ratio), listener = reader(0.1);
    RunBench bench;
    bench.add("source", source).add("reader", listener).schedule(GetParam());
    bench.connect("source.y", "reader.u", "lagrange3").connect("reader.y", "source.u", "lagrange1").run(12.0);
    expect_cubic(bench.recording, 1);
    EXPECT_EQ(bench.recording.rows(1).size(), 121U);
  }
}

TEST_P(EachSchedule, CarriesItOverThreeSubsystems) {
  Scripted source = cubic_source(0.3), middle = cubic_source(0.25), listener = reader(0.07);
  RunBench bench;
  bench.add("reader", listener).add("source", source).add("middle", middle).schedule(GetParam());
  bench.connect("source.y", "reader.u", "lagrange4")
      .connect("source.y", "middle.u", "hermite")
      .connect("reader.y", "source.u", "lagrange1");
  bench.run(10.0);
  expect_cubic(bench.recording, 0);
  EXPECT_EQ(bench.recording.rows(2).size(), 41U);
}

TEST_P(EachSchedule, AMemoryIsAnOwnStepOfTheReaderAndADelayACommunicationStep) {
  const std::pair<Lag, double> lags[] = {{Lag::memory, 0.1}, {Lag::delay, 0.3}};
  for (const auto& [lag, length] : lags)
    for (const double step : {0.0, 0.45}) {
      Scripted source = test::source(0.3, [](double t) { return 7.0 * t; }), listener = reader(0.1);
      RunBench bench;
      bench.add("source", source).add("reader", listener).schedule(GetParam());
      bench.connect("source.y", "reader.u", "lagrange1", lag);
      if (step > 0.0) bench.coordination.communication_step = step;
      bench.run(6.0);
      const double shift = lag == Lag::delay && step > 0.0 ? step : length;
      for (const auto& row :
           bench.recording.rows(1))  // the first straight line is there from 0.3 on, or a step later
        if (row[0] > shift + 0.61) {
          EXPECT_NEAR(row[2], 7.0 * (row[0] - shift), 1e-13) << row[0];
        }
    }
}

TEST_P(EachSchedule, RunsOneSubsystemAlone) {
  Scripted alone = test::source(0.1, cubic);
  RunBench bench;
  bench.add("alone", alone).schedule(GetParam()).run(2.05, 1.0);
  ASSERT_EQ(bench.recording.rows(0).size(), 11U);
  EXPECT_EQ(bench.recording.time(0, 10), 2.0);
}

TEST_P(EachSchedule, TakesSubsystemsThatChooseTheirSteps) {
  Scripted source = cubic_source(0.1, {.chooses_step = true}), listener = reader(0.1);
  double next = 0.1, step = 0.1;  // steps grow by a tenth each, up to 0.8
  source.instead_of_advance = [&](double t_limit, bool, std::span<const Signal> u, Samples& y) {
    while (!y.full() && next <= t_limit) {
      source.grid().cut(next);
      source.put(u, y);
      next += step = std::min(1.1 * step, 0.8);
    }
    return Clock{source.grid().time(), next, Stop::limit};
  };
  RunBench bench;
  bench.add("source", source).add("reader", listener).schedule(GetParam());
  bench.connect("source.y", "reader.u", "lagrange3").connect("reader.y", "source.u", "lagrange1").run(12.0);
  expect_cubic(bench.recording, 1);
  EXPECT_EQ(bench.recording.rows(1).size(), 121U);
  EXPECT_GT(bench.recording.rows(0).size(), 20U);
}

TEST_P(EachSchedule, CallsAgainWhoStoppedEarlyAtAnEvent) {
  for (const bool early : {false, true}) {
    Scripted source = cubic_source(0.1), listener = reader(0.25);
    if (early)
      source.instead_of_advance = [&](double t_limit, bool, std::span<const Signal> u, Samples& y) {
        if (!source.grid().fits(t_limit)) return source.clock(Stop::limit);
        source.grid().step();
        source.put(u, y);
        return source.clock(Stop::event);
      };
    RunBench bench;
    bench.add("source", source).add("reader", listener).schedule(GetParam());
    bench.connect("source.y", "reader.u", "lagrange3").connect("reader.y", "source.u", "lagrange1").run(10.0);
    expect_cubic(bench.recording, 1);
    EXPECT_EQ(bench.recording.rows(0).size(), 101U);
    EXPECT_EQ(bench.recording.rows(1).size(), 41U);
  }
}

TEST_P(EachSchedule, FitsNothingAcrossAJump) {
  // 1 before t = 1 and the cubic from there on; it repeats the time 1 with a jump.
  Scripted source({"jumping", {}, {{"y", "1"}}, {}, {}}, 0.1,
                  [](double, const auto&, double* y) { y[0] = 1.0; });
  source.instead_of_advance = [&](double t_limit, bool, std::span<const Signal>, Samples& y) {
    while (!y.full() && source.grid().fits(t_limit)) {
      source.grid().step();
      const double t = source.grid().time();
      if (t <= 1.0) y.append(t)[0] = 1.0;
      if (t == 1.0) y.append(t, true)[0] = cubic(t);
      if (t > 1.0) y.append(t)[0] = cubic(t);
    }
    return source.clock(Stop::limit);
  };
  Scripted listener = reader(0.25);
  RunBench bench;
  bench.add("source", source)
      .add("reader", listener)
      .schedule(GetParam())
      .connect("source.y", "reader.u", "lagrange3")
      .run(3.0);
  for (std::size_t row = 0; row < bench.recording.rows(1).size(); ++row) {
    const double t = bench.recording.time(1, row), value = bench.recording.value(1, row);
    if (t <= 1.0) {
      EXPECT_EQ(value, 1.0) << t;
    } else if (t >
               1.65) {  // four samples take 0.3 s, and parallel reads those of its last communication point
      EXPECT_NEAR(value, cubic(t), 1e-9) << t;
    }
  }
}

TEST_P(EachSchedule, GoesOnWhenOneHasFinished) {
  for (const bool at_once : {false, true}) {
    Scripted brief = cubic_source(0.1), listener = reader(0.25, {.lands = true});
    brief.instead_of_advance = [&](double t_limit, bool, std::span<const Signal> u, Samples& y) {
      for (; brief.grid().time() < 1.0 && brief.grid().fits(t_limit); brief.put(u, y)) brief.grid().step();
      return brief.clock(brief.grid().time() < 1.0 ? Stop::limit : Stop::finished);
    };
    if (at_once)
      brief.instead_of_initialize = [&](double t, std::span<const double>, Samples& y) {
        Polynomial p = cubic;
        double* row = y.append(t);
        for (int k = 0; k <= 3; ++k, p = p.derivative()) row[k] = p(t);
        return Clock{t, INFINITY, Stop::finished};
      };
    RunBench bench;
    bench.add("brief", brief).add("reader", listener).schedule(GetParam());
    bench.connect("brief.y", "reader.u", "lagrange3").connect("reader.y", "brief.u", "lagrange1");
    ASSERT_NO_THROW(bench.run(3.1)) << at_once;
    EXPECT_EQ(bench.coordinator->time(1), 3.1);
    if (!at_once) expect_cubic(bench.recording, 1);
  }
}

}  // namespace
}  // namespace tandem
