// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Orders of the reconstructions with sides that are propagated exactly, so that the coupling is the only
// error. A whole frequency ratio and one that is not: 3 from 160 steps per cycle on, 7.3 from 640 on (its
// extrapolation spans more).
#include <algorithm>

#include "expect_order.hpp"

namespace tandem::test {
namespace {

class Order : public testing::TestWithParam<Place> {};

TEST_P(Order, OfLagrangeIsItsDegreePlusOne) {
  TwoMassRun what = GetParam().run();
  for (int degree = 0; degree <= 4; ++degree) {
    what.set_scheme("lagrange" + std::to_string(degree));
    expect_order(what, GetParam().coarsest, degree + 1);
  }
}

TEST_P(Order, OfHermiteIsFour) {
  TwoMassRun what = GetParam().run();
  what.set_scheme("hermite");
  expect_order(what, GetParam().coarsest, 4);
}

TEST_P(Order, OfTwoDegreesIsThatOfTheLower) {
  TwoMassRun what = GetParam().run();
  what.to_fast = "lagrange1", what.to_slow = "lagrange3";
  expect_order(what, GetParam().coarsest, 2);
  what.to_fast = "lagrange3", what.to_slow = "lagrange1";
  expect_order(what, 4 * GetParam().coarsest,
               2);  // what is extrapolated at degree 3 hides the order at first
}

// Extra samples widen the constants.
TEST_P(Order, OfLeastSquaresIsItsDegreePlusOne) {
  TwoMassRun what = GetParam().run();
  for (int degree = 0; degree <= 4; ++degree)
    for (const char* extra : {"_2", "_4"}) {
      what.set_scheme("least_squares" + std::to_string(degree) + extra);
      expect_order(what, std::max(320.0, GetParam().coarsest), degree + 1);
    }
}

using enum Schedule::Kind;
INSTANTIATE_TEST_SUITE_P(Exact, Order,
                         testing::Values(Place{slowest_first, 3, 160}, Place{fastest_first, 3, 160},
                                         Place{parallel, 3, 160}, Place{slowest_first, 7.3, 640},
                                         Place{fastest_first, 7.3, 640}, Place{parallel, 7.3, 640}),
                         place_name);

}  // namespace
}  // namespace tandem::test
