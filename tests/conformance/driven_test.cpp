// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Inputs that are data over time, against the exact solution.
#include <gtest/gtest.h>

#include "cut_run.hpp"
#include "driven_models.hpp"
#include "refusal.hpp"

namespace tandem::test {
namespace {

using Between = TimeSeries::Between;
using Beyond = TimeSeries::Beyond;

const std::vector<TimeSeries::How> hows = {{Between::linear, Beyond::refuse},
                                           {Between::linear, Beyond::hold},
                                           {Between::hold, Beyond::refuse},
                                           {Between::hold, Beyond::hold}};

std::shared_ptr<const TimeSeries> random(unsigned seed, TimeSeries::How how, double start) {
  std::mt19937 numbers(seed);
  return std::make_shared<TimeSeries>(random_series(numbers, how, start));
}

/// Steps that fit nothing, shorter and longer than the gaps between points.
TEST(Driven, OneThatLandsIsRightToRoundingAndTellsBothSidesOfEachJump) {
  for (unsigned seed = 0; seed < 40; ++seed)
    for (const TimeSeries::How how : hows) {
      const double start = seed % 4 == 0 ? -3.7 : 0.0, step = 0.003 + 0.0071 * (seed % 20);
      const auto data = random(seed, how, start);
      FixedStep subsystem{Integral(step)};
      RunBench bench;
      bench.add("a", subsystem).coordination.landing["a"] = Landing::always;
      bench.topology.drive("a.u", data);
      const Recording& r = bench.run(start + 1.0, start);
      std::size_t jumps = 0;
      for (std::size_t k = 0; k < r.rows(0).size(); ++k) {
        const double t = r.time(0, k);
        EXPECT_NEAR(r.value(0, k), integral(*data, t), 1e-14 * (1.0 + 50.0 * std::abs(start)));
        const bool left = k + 1 < r.rows(0).size() && r.time(0, k + 1) == t;
        const double u = data->value(left ? std::nextafter(t, -9.0) : t);
        EXPECT_NEAR(r.value(0, k, 1), r.value(0, k) + u, 1e-12) << seed << " t = " << t;
        jumps += r.rows(0)[k][1] != 0.0;
      }
      const auto all = data->jumps();
      EXPECT_EQ(jumps, static_cast<std::size_t>(std::count_if(
                           all.begin(), all.end(), [&](double t) { return t > start && t < start + 1.0; })))
          << seed;
    }
}

/// Own steps do not end at its points, where only a third derivative jumps.
TEST(Driven, ASplineKeepsOrderFour) {
  double before = 0.0;
  for (const double h : {0.008, 0.001}) {
    double sum = 0.0;
    for (unsigned seed = 0; seed < 20; ++seed) {
      const auto data = random(seed, {Between::spline, Beyond::refuse}, 0.0);
      FixedStep subsystem{Integral(h)};
      RunBench bench;
      bench.add("a", subsystem).topology.drive("a.u", data);
      sum += std::abs(bench.run(1.0).rows(0).back()[2] - integral(*data, 1.0));
    }
    if (before > 0.0) {
      EXPECT_NEAR(std::log2(before / sum) / 3.0, 4.0, 0.3) << sum;
    }
    before = sum;
  }
}

/// A carrier whose output jumps with its input, and one that integrates that output: with held data it is a
/// line from jump to jump.
struct Carried {
  Carried(std::shared_ptr<const TimeSeries> data, double step, double of_reader, const std::string& schedule,
          Landing landing = Landing::automatic)
      : carrier{Integral(step)}, reader{Integral(of_reader)} {
    bench.add("carrier", carrier).add("reader", reader).connect("carrier.y", "reader.u", "lagrange1");
    bench.schedule(schedule).topology.drive("carrier.u", std::move(data));
    bench.coordination.landing = {{"carrier", landing}, {"reader", landing}};
  }
  FixedStep<Integral> carrier, reader;
  RunBench bench;
};

/// The integral of x + u, of held data from 0 s on.
double carried(const TimeSeries& data, double t) {
  double x = 0.0, sum = 0.0;
  for (const Segment& s : data.pieces()) {
    if (s.origin >= t) break;
    const double h = std::min(s.end, t) - s.origin, u = s.c[0];
    sum += h * (x + u) + h * h / 2.0 * u;
    x += h * u;
  }
  return sum;
}

double error_of(Carried scene, const TimeSeries& data) {
  const Recording& r = scene.bench.run(1.0);
  double largest = 0.0;
  for (std::size_t k = 0; k < r.rows(1).size(); ++k)
    largest = std::max(largest, std::abs(r.value(1, k) - carried(data, r.time(1, k))));
  return largest;
}

TEST(Driven, WhoFollowsACarrierSeesItsJumpsInTime) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto data = random(seed, {Between::hold, Beyond::hold}, 0.0);
    EXPECT_LT(error_of({data, 0.02, 0.0131, "slowest-first"}, *data), 1e-14) << seed;
    EXPECT_LT(error_of({data, 0.0131, 0.02, "fastest-first"}, *data), 1e-14) << seed;
    EXPECT_LT(error_of({data, 0.02, 0.0131, "slowest-first", Landing::always}, *data), 1e-14) << seed;
  }
}

/// Extrapolated over one step after each jump, where one sample is known: order 2. Without steps that end at
/// the jumps it is 1.
TEST(Driven, WhoLeadsACarrierOrGoesBesideItErrsToOrderTwoAtItsJumps) {
  for (const std::string schedule : {"fastest-first", "parallel"}) {
    double before = 0.0, missed = 0.0;
    for (const double h : {0.008, 0.001}) {
      double sum = 0.0, sum_missed = 0.0;
      for (unsigned seed = 0; seed < 20; ++seed) {
        const auto data = random(seed, {Between::hold, Beyond::hold}, 0.0);
        sum += error_of({data, h, 0.7 * h, schedule}, *data);
        sum_missed += error_of({data, h, 0.7 * h, schedule, Landing::never}, *data);
      }
      if (before > 0.0) {
        EXPECT_NEAR(std::log2(before / sum) / 3.0, 2.0, 0.2) << schedule << " " << sum;
        EXPECT_NEAR(std::log2(missed / sum_missed) / 3.0, 1.0, 0.3) << schedule << " " << sum_missed;
      }
      before = sum, missed = sum_missed;
    }
  }
}

TEST(Driven, ACutChangesNothing) {
  for (const std::string schedule : {"slowest-first", "fastest-first", "parallel"})
    for (unsigned seed = 0; seed < 3; ++seed) {
      const auto data = random(seed, hows[seed], 0.0);
      const auto whole = Carried(data, 0.05, 0.017, schedule).bench.run(1.0).all();
      for (int cut = 0; cut < 60; cut += 7) {
        Carried before(data, 0.05, 0.017, schedule), after(data, 0.05, 0.017, schedule);
        EXPECT_TRUE(same_bits(cut_after(cut, before.bench, after.bench, {0.0, 1.0}), whole)) << cut;
      }
    }
}

/// At an instant on a jump the value after it.
TEST(Driven, ASampledOneReadsWhatHoldsAtItsInstants) {
  const auto data = std::make_shared<TimeSeries>("data", std::vector{0.0, 0.3, 0.3, 1.0},
                                                 std::vector{0.0, 3.0, 7.0, 0.0}, TimeSeries::How{});
  Sampled sampled{Reading(0.1)};
  RunBench bench;
  bench.add("s", sampled).topology.drive("s.u", data);
  const Recording& r = bench.run(1.0);
  ASSERT_EQ(r.rows(0).size(), 12U);
  for (std::size_t k = 1; k < 12; ++k)
    EXPECT_NEAR(r.value(0, k), data->value(r.time(0, k) + 1e-12), 1e-10) << k;
}

TEST(Driven, DataThatDoNotCoverTheRunAreRefusedBeforeIt) {
  const auto data = std::make_shared<TimeSeries>("file d.csv", std::vector{0.0, 0.5}, std::vector{0.0, 3.0},
                                                 TimeSeries::How{});
  FixedStep subsystem{Integral(0.1)};
  RunBench bench;
  bench.add("a", subsystem).topology.drive("a.u", data);
  EXPECT_TRUE(
      refuses(ErrorCode::invalid_argument,
              {"input a.u is driven by file d.csv, which has data from 0 to 0.5 s; the run goes from 0 to 1 "
               "s; allowed are data for all of it, or beyond = \"hold\""},
              [&] { bench.run(1.0); }));
  EXPECT_NO_THROW(bench.run(0.5));
}

/// And who steps over jumps, and why.
TEST(Driven, NotesTellWhoDoesNotEndStepsAtJumps) {
  const auto data = random(1, {Between::hold, Beyond::hold}, 0.0);
  const auto notes = [&](double step, Landing landing) {
    FixedStep subsystem{Integral(step)};
    RunBench bench;
    bench.add("a", subsystem).topology.drive("a.u", data);
    bench.coordination.landing["a"] = landing;
    bench.run(1.0);
    std::string all;
    for (const std::string& note : bench.coordinator->notes()) all += note + "\n";
    return all;
  };
  const std::string
      who = "subsystem 'a' does not end own steps at the jumps that its inputs are known to have, as ",
      so = "; where it does not split them there itself, it errs to first order\n";
  EXPECT_EQ(notes(0.01, Landing::automatic), "");
  EXPECT_EQ(notes(0.01, Landing::never), who + "land = \"never\" says so" + so);
  EXPECT_EQ(notes(0.25, Landing::automatic), who + "they come more often than its own steps" + so);
  EXPECT_EQ(notes(0.25, Landing::always), "");
}

TEST(Driven, AnInputHasOneSource) {
  const auto data = random(1, {}, 0.0);
  FixedStep a{Integral(0.1)}, b{Integral(0.1)};
  RunBench bench;
  bench.add("a", a).add("b", b).connect("a.x", "b.u").topology.drive("a.u", data);
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"input b.u is driven by data and connected"},
                      [&] { bench.topology.drive("b.u", data); }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"input a.u is driven by data and connected"},
                      [&] { bench.connect("b.x", "a.u"); }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"input a.u is driven by data and driven once more"},
                      [&] { bench.topology.drive("a.u", data); }));
}

}  // namespace
}  // namespace tandem::test
