// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/exchange.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "connection.hpp"

namespace tandem {
namespace {

using test::added;
using test::connection;

double f(double t) { return std::sin(2.0 * t) + 0.2 * t; }
double g(double t) { return std::cos(3.0 * t) - 0.1 * t; }

const SubsystemInfo source_info{"source", {}, {{"y", "1", 1, 1}}, {}, {}};
const SubsystemInfo reader_info{
    "reader", {{"sum", "1"}, {"a", "1"}, {"b", "1"}, {"c", "1", 2, 0, 7.5}}, {}, {}, {}};

/// Sources a = f(t) and b = g(t), each on a grid of its own; the reader gets both of them and their sum.
class Bench {
 public:
  Bench(const std::string& how_a, const std::string& how_b, double delay_a = 0.0,
        std::int64_t capacity = 32) {
    topology_.add("a", source_info);
    topology_.add("b", source_info);
    topology_.add("reader", reader_info);
    const Lag lag = delay_a > 0.0 ? Lag::delay : Lag::none;
    for (Connection c :
         {added(connection("a.y", "reader.sum", how_a, lag)), connection("a.y", "reader.a", how_a, lag)}) {
      c.gain = 2.0;
      c.offset = 0.25;
      topology_.connect(c);
    }
    topology_.connect(added(connection("b.y", "reader.sum", how_b)));
    topology_.connect(connection("b.y", "reader.b", how_b));
    const std::int64_t capacities[] = {capacity, capacity, capacity};
    exchange.emplace(topology_, 0.0, LinkTimes{{1.0, 1.0, 1.0}, delay_a}, capacities);
    for (const int i : {0, 1}) give(i, 1);
  }
  void give(int source, int rows) {
    if (!exchange->history(source).has_room(rows)) exchange->make_room(source, rows);
    for (int k = 0; k < rows; ++k) {
      const double t = times_[source] = static_cast<double>(given_[source]++) * (source == 0 ? 0.3 : 0.25);
      double* y = exchange->history(source).room().append(t);
      y[0] = source == 0 ? f(t) : g(t);
      y[1] = source == 0 ? 2.0 * std::cos(2.0 * t) + 0.2 : -3.0 * std::sin(3.0 * t) - 0.1;
    }
    exchange->commit(source, times_[source]);
  }
  std::span<const Signal> read(double from, double to) { return read(from, to, to); }
  std::span<const Signal> read(double from, double next, double limit) {
    return exchange->inputs(2, from, next, limit);
  }
  /// The reader gives its sample at t: it will not read before it.
  void stand(double t) {
    if (!exchange->history(2).has_room(1)) exchange->make_room(2, 1);
    exchange->history(2).room().append(t);
    exchange->commit(2, t);
  }

  std::optional<Exchange> exchange;

 private:
  Topology topology_;
  double times_[2] = {};
  int given_[2] = {};
};

TEST(Exchange, ASumIsTheSumOfItsTermsWhateverTheirGrids) {
  const char* kinds[] = {"lagrange0", "lagrange1",        "lagrange3", "lagrange4",
                         "hermite",   "least_squares2_2", "mean",      "matched_hold"};
  for (const char* how_a : kinds)
    for (const char* how_b : kinds) {
      Bench bench(how_a, how_b);
      bench.give(0, 9);
      bench.give(1, 8);
      const auto u = bench.read(0.0, 2.0, 3.4);
      // Extrapolation of degree 4 by 0.7 is below 1e3 in size, and a Taylor shift of it takes some 30
      // operations.
      for (double t = 0.0; t < 3.4; t += 1.0 / 64.0)
        ASSERT_NEAR(u[0].value(t), u[1].value(t) + u[2].value(t), 1e-11)
            << how_a << " + " << how_b << " at " << t;
    }
}

TEST(Exchange, ASumOfALateTermBreaksWhereThatTermBreaks) {
  Bench bench("lagrange0", "lagrange1", 0.11);
  bench.give(0, 9);
  bench.give(1, 8);
  const auto u = bench.read(0.0, 2.0, 3.4);
  for (double t = 0.0; t < 3.4; t += 1.0 / 128.0)
    ASSERT_NEAR(u[0].value(t), u[1].value(t) + u[2].value(t), 1e-13) << t;
}

/// However many pieces of its terms are known beyond it.
TEST(Exchange, ASumHasThePiecesOfItsCallAlone) {
  Bench bench("lagrange3", "lagrange3", 0.0, 3000);
  bench.give(0, 500);
  bench.give(1, 500);
  EXPECT_LE(bench.read(0.0, 0.3)[0].segments().size(), 5U);
  EXPECT_GE(bench.read(0.0, 30.0)[0].segments().size(), 200U);
}

TEST(Exchange, ASumReadsTheSameBitsFromWhereverTheCallBegins) {
  for (const char* how : {"lagrange1", "lagrange4", "hermite"}) {
    Bench bench(how, how);
    bench.give(0, 10);
    bench.give(1, 10);
    std::vector<double> all;
    for (double t = 0.0; t < 3.0; t += 0.05) all.push_back(bench.read(0.0, 3.0)[0].value(t + 0.02));
    std::size_t k = 0;
    for (double t = 0.0; t < 3.0; t += 0.05)
      ASSERT_EQ(bench.read(t, t + 0.05)[0].value(t + 0.02), all[k++]) << how << " at " << t;
  }
}

TEST(Exchange, AnInputWithoutConnectionKeepsItsStartValue) {
  Bench bench("lagrange1", "lagrange1");
  for (int k = 0; k < 3; ++k) {
    for (const std::size_t input : {3U, 4U}) {
      EXPECT_EQ(bench.read(0.1 * k, 1.0)[input].value(17.0), 7.5);
      EXPECT_EQ(bench.read(0.1 * k, 1.0)[input].derivative(17.0), 0.0);
    }
    bench.give(0, 1);
  }
  EXPECT_EQ(bench.read(0.0, 1.0).size(), 5U);
}

TEST(Exchange, DroppedRowsAndNewMemoryChangeNoBit) {
  for (const char* how : {"lagrange0", "lagrange4", "hermite", "least_squares3_4", "mean", "matched_hold"}) {
    const double delay = Reconstruction::parse(how).follows_samples() ? 0.11 : 0.0;
    Bench moving(how, how, delay), still(how, how, delay, 100'000);
    double from = 0.0;
    for (int round = 0; round < 200; ++round) {
      const int rows = round < 50 ? 1 : 40;  // later the batches take more memory
      for (Bench* bench : {&moving, &still}) bench->give(0, 5 * rows), bench->give(1, 6 * rows);
      const double span = 1.5 * rows;
      const auto u = moving.read(from, from + span), expected = still.read(from, from + span);
      for (const std::size_t input : {0U, 1U, 2U})
        for (double t = from; t < from + 1.3 * span; t += 0.37)
          ASSERT_EQ(u[input].value(t), expected[input].value(t)) << how << " round " << round << " at " << t;
      from += span;
      moving.stand(from);
      still.stand(from);
    }
    EXPECT_EQ(still.exchange->history(0).oldest(), 0);
    EXPECT_GT(moving.exchange->history(0).oldest(), 10'000);
    EXPECT_LE(moving.exchange->history(0).capacity(), 2048);
  }
}

/// The reader stands at 1.25 s when source a goes back to 0.6 s, and its memory has moved in between.
TEST(Exchange, ASourceGoesBackToBeforeItsReaderWhenMemoryHasMoved) {
  Bench bench("lagrange1", "lagrange1"), still("lagrange1", "lagrange1");
  for (Bench* b : {&bench, &still}) b->give(0, 5), b->give(1, 6), b->read(1.25, 1.5);
  bench.exchange->keep_from(0, 0.6);
  bench.stand(1.25);
  bench.exchange->make_room(0, 1);
  bench.exchange->withdraw(0, 3);
  for (const double t : {0.9, 1.2, 1.5}) {
    double* y = bench.exchange->history(0).room().append(t);
    y[0] = f(t), y[1] = 0.0;
    bench.exchange->commit(0, t);
  }
  for (const double t : {1.25, 1.4, 1.5})
    EXPECT_EQ(bench.read(1.25, 1.5)[1].value(t), still.read(1.25, 1.5)[1].value(t)) << t;
}

TEST(Exchange, TwoOutputsOfOneSourceAddUp) {
  const SubsystemInfo two{"two", {}, {{"p", "1", 2}}, {}, {}}, one{"one", {{"u", "1"}}, {}, {}, {}};
  Topology topology;
  topology.add("two", two);
  topology.add("one", one);
  topology.connect(added(connection("two.p[0]", "one.u", "lagrange1")));
  topology.connect(added(connection("two.p[1]", "one.u", "lagrange1")));
  topology.connect(added(connection("two.p[1]", "one.u", "lagrange0")));
  const std::int64_t capacities[] = {32, 32};
  Exchange exchange(topology, 0.0, {{1.0, 1.0}, 1.0}, capacities);
  for (const double t : {0.0, 1.0, 2.0}) {
    double* y = exchange.history(0).room().append(t);
    y[0] = 10.0 * t;
    y[1] = 100.0 * t;
  }
  exchange.commit(0, 2.0);
  EXPECT_EQ(exchange.inputs(1, 0.0, 1.0, 1.0)[0].value(0.5), 5.0 + 50.0 + 100.0);
  EXPECT_EQ(exchange.inputs(1, 2.0, 3.0, 3.0)[0].value(3.0), 30.0 + 300.0 + 200.0);
}

/// Four terms of very different sizes, of three sources, to a reader that integrates itself and a sampled
/// one.
TEST(Exchange, ASumHasTheSameBitsInWhateverOrderItsTermsAreConnected) {
  const SubsystemInfo two{"two", {}, {{"p", "1", 2}}, {}, {}};
  SubsystemInfo one{"one", {{"u", "1"}}, {{"y", "1"}}, {}, {}};
  one.outputs[0].held = true;
  for (const bool sampled : {false, true}) {
    one.abilities.sampled = sampled;
    one.sampling.period = sampled ? 0.5 : 0.0;
    const auto sum = [&](const std::vector<int>& order) {
      std::vector<Connection> terms = {
          connection("a.p[0]", "one.u", "lagrange1"), connection("a.p[1]", "one.u"),
          connection("b.p[0]", "one.u", "lagrange1"), connection("a.p[1]", "one.u")};
      terms[3].gain = 1e-9 / 3.0;
      Topology topology;
      for (const char* name : {"a", "b"}) topology.add(name, two);
      topology.add("one", one);
      for (const int k : order) topology.connect(added(terms[static_cast<std::size_t>(k)]));
      const std::int64_t capacities[] = {32, 32, 32};
      Exchange exchange(topology, 0.0, {{1.0, 1.0, 1.0}, 1.0}, capacities);
      for (const int i : {0, 1}) {
        double* y = exchange.history(i).room().append(0.0);
        y[0] = i == 0 ? 1.0 / 3.0 : -1.0 / 3.0 + 1e-9;
        y[1] = 1e5 / 7.0;
        exchange.commit(i, 0.0);
      }
      return sampled ? exchange.sample(2, {0.0, 0.5})[0] : exchange.inputs(2, 0.0, 1.0, 1.0)[0].value(0.5);
    };
    std::vector<int> order = {0, 1, 2, 3};
    const double expected = sum(order);
    while (std::next_permutation(order.begin(), order.end())) EXPECT_EQ(sum(order), expected) << sampled;
  }
}

}  // namespace
}  // namespace tandem
