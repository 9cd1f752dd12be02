// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Subsystems that break the contract: each ends the run with one Error that names the instance, the call and
// the time.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "refusal.hpp"
#include "run_bench.hpp"
#include "scripted.hpp"
#include "word.hpp"

namespace tandem {
namespace {

using test::refuses;
using test::RunBench;
using test::Scripted;

/// "good" and "bad" read one another; both have steps of 0.1 s, and "bad" has its way from t = 0.5 on.
class BrokenContract : public testing::TestWithParam<const char*> {
 protected:
  BrokenContract() {
    bench.add("good", good).add("bad", bad).schedule(GetParam());
    bench.connect("good.y", "bad.u", "lagrange1").connect("bad.y", "good.u", "lagrange1");
  }

  /// What happens if `bad` does that once it stands at t = 0.5 or later.
  using Deed = std::function<Clock(double t_limit, std::span<const Signal> u, Samples& y)>;
  testing::AssertionResult refuses_deed(std::vector<std::string> texts, const Deed& deed) {
    texts.push_back("subsystem 'bad', advance at t = 0.5 s to 0.6");
    bad.instead_of_advance = [this, deed](double t_limit, bool, std::span<const Signal> u, Samples& y) {
      if (bad.grid().time() > 0.45) return deed(t_limit, u, y);
      while (bad.grid().fits(t_limit)) bad.grid().step(), bad.put(u, y);
      return bad.clock(Stop::limit);
    };
    return refuses(ErrorCode::numerical, texts, [this] { bench.run(2.0); });
  }

  Scripted good = test::listener(0.1), bad = test::listener(0.1);
  RunBench bench;
};

TEST_P(BrokenContract, ByAValueThatIsNotFinite) {
  for (const double value : {NAN, INFINITY})
    EXPECT_TRUE(refuses_deed({"y", "not finite", "0.6"}, [&](double, auto, Samples& y) {
      bad.grid().step();
      y.append(bad.grid().time())[0] = value;
      return bad.clock(Stop::limit);
    }));
}

TEST_P(BrokenContract, ByGoingPastTheLimit) {
  EXPECT_TRUE(refuses_deed({"past its limit"}, [&](double t_limit, auto u, Samples& y) {
    while (bad.grid().time() <= t_limit) bad.grid().step();
    bad.put(u, y);
    return bad.clock(Stop::limit);
  }));
}

TEST_P(BrokenContract, ByAClockThatDiffersFromTheNewestSample) {
  EXPECT_TRUE(refuses_deed({"0.5", "newest sample"}, [&](double, auto u, Samples& y) {
    bad.grid().step();
    bad.put(u, y);
    return Clock{0.55, bad.grid().next(), Stop::limit};
  }));
  EXPECT_TRUE(refuses_deed({"newest sample"}, [&](double, auto, Samples&) {
    bad.grid().step();  // and no sample
    return bad.clock(Stop::limit);
  }));
  EXPECT_TRUE(refuses_deed({"nan"}, [&](double, auto u, Samples& y) {
    bad.grid().step();
    bad.put(u, y);
    return Clock{NAN, bad.grid().next(), Stop::limit};
  }));
}

TEST_P(BrokenContract, ByANextStepThatDoesNotEndLater) {
  for (const double ahead : {0.0, -0.1, double{-INFINITY}, double{NAN}})
    EXPECT_TRUE(refuses_deed({"0.6", "not later"}, [&](double, auto u, Samples& y) {
      bad.grid().step();
      bad.put(u, y);
      return Clock{bad.grid().time(), bad.grid().time() + ahead, Stop::limit};
    }));
}

TEST_P(BrokenContract, ByNotMoving) {
  for (const Stop stop : {Stop::limit, Stop::event, Stop::samples_full})
    EXPECT_TRUE(refuses_deed({"not moved"}, [&](double, auto, Samples&) { return bad.clock(stop); }));
}

TEST_P(BrokenContract, NotByReturningOftenBetweenItsSteps) {
  int calls = 0;
  bad.instead_of_advance = [&](double t_limit, bool, std::span<const Signal> u, Samples& y) {
    if (++calls % 60 == 0 && bad.grid().fits(t_limit)) bad.grid().step(), bad.put(u, y);
    return bad.clock(Stop::event);
  };
  EXPECT_NO_THROW(bench.run(2.0)) << "59 calls without progress, again and again";
}

TEST_P(BrokenContract, ByTimesThatDoNotRise) {
  EXPECT_TRUE(refuses_deed({"0.5", "does not come after"}, [&](double, auto u, Samples& y) {
    bad.put(u, y);  // the sample of 0.5 again
    bad.grid().step();
    bad.put(u, y);
    return bad.clock(Stop::limit);
  }));
}

TEST_P(BrokenContract, ByAnErrorOfItsOwnIsToldWithTheCall) {
  EXPECT_TRUE(refuses_deed({" s: no convergence in 20 iterations"}, [](double, auto, Samples&) -> Clock {
    throw Error(ErrorCode::numerical, "no convergence in 20 iterations");
  }));
}

TEST_P(BrokenContract, WhatWasTrueUntilThenIsKept) {
  EXPECT_TRUE(
      refuses_deed({}, [](double, auto, Samples&) -> Clock { throw Error(ErrorCode::numerical, ""); }));
  for (const int who : {0, 1}) {
    ASSERT_GE(bench.recording.rows(who).size(), 5U);
    EXPECT_EQ(bench.recording.time(who, 4), 0.4);
  }
}

INSTANTIATE_TEST_SUITE_P(Schedules, BrokenContract,
                         testing::Values("slowest-first", "fastest-first", "parallel"),
                         [](const auto& p) { return test::word(p.param); });

/// What happens at the start if "bad" initializes itself like that.
testing::AssertionResult refuses_start(
    const std::vector<std::string>& texts,
    const std::function<Clock(double, std::span<const double>, Samples&)>& deed) {
  Scripted good = test::listener(0.1), bad = test::listener(0.1);
  bad.instead_of_initialize = deed;
  RunBench bench;
  bench.add("good", good).add("bad", bad).connect("good.y", "bad.u").connect("bad.y", "good.u");
  return refuses(ErrorCode::numerical, texts, [&] { bench.run(1.0); });
}

TEST(BrokenStart, ByAnotherNumberOfSamplesThanOne) {
  EXPECT_TRUE(refuses_start({"'bad'", "0 samples"}, [](double t, auto, Samples&) {
    return Clock{t, t + 0.1, Stop::limit};
  }));
}

TEST(BrokenStart, ByAnotherTimeThanTheStart) {
  EXPECT_TRUE(refuses_start({"'bad'", "t = 0.1 s"}, [](double t, auto, Samples& y) {
    y.append(t + 0.1)[0] = 0.0;
    return Clock{t + 0.1, t + 0.2, Stop::limit};
  }));
  EXPECT_TRUE(refuses_start({"'bad'", "t = 0.1 s"}, [](double t, auto, Samples& y) {
    y.append(t)[0] = 0.0;
    return Clock{t + 0.1, t + 0.2, Stop::limit};
  }));
}

TEST(BrokenStart, ByAFirstStepThatIsNone) {
  for (const double step : {0.0, -1.0, double{INFINITY}, double{NAN}})
    EXPECT_TRUE(refuses_start({"'bad'", "first own step"}, [step](double t, auto, Samples& y) {
      y.append(t)[0] = 0.0;
      return Clock{t, t + step, Stop::limit};
    }));
}

TEST(BrokenStart, ByAnOutputThatIsNotFiniteThoughNothingUnknownFeedsThrough) {
  EXPECT_TRUE(refuses_start({"bad.y", "not finite at the start"},
                            [](double t, std::span<const double> u0, Samples& y) {
                              y.append(t)[0] = u0[0];  // feedthrough that it did not declare
                              return Clock{t, t + 0.1, Stop::limit};
                            }));
}

}  // namespace
}  // namespace tandem
