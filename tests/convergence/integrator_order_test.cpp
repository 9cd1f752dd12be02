// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The sides of the two-mass test as they are: Runge-Kutta of order 4 and the trapezoidal rule of order 2. A
// coupled run has the lowest order of all that is in it; one exact side shows what the other allows.
#include <algorithm>

#include "expect_order.hpp"

namespace tandem::test {
namespace {

class IntegratorOrders : public testing::TestWithParam<Place> {};

// The trapezoidal rule's second-order error hides the first-order one of degree 0 in x2 until 1280 steps per
// cycle.
TEST_P(IntegratorOrders, OfBothMassesIsTwoAndOneWithDegreeZero) {
  TwoMassRun what = GetParam().run();
  what.fast = real_fast(), what.slow = real_slow();
  for (int degree = 0; degree <= 4; ++degree) {
    what.set_scheme("lagrange" + std::to_string(degree));
    expect_order(what, degree == 0 ? 1280 : GetParam().coarsest, std::min(degree + 1, 2));
  }
}

TEST_P(IntegratorOrders, OfRungeKuttaBesideAnExactSideIsDegreePlusOneUpToFour) {
  TwoMassRun what = GetParam().run();
  what.fast = real_fast();
  for (int degree = 0; degree <= 3; ++degree) {
    what.set_scheme("lagrange" + std::to_string(degree));
    expect_order(what, GetParam().coarsest, degree + 1);
  }
}

TEST_P(IntegratorOrders, OfTheTrapezoidalRuleBesideAnExactSideIsTwo) {
  TwoMassRun what = GetParam().run();
  what.slow = real_slow();
  for (const char* scheme : {"lagrange1", "lagrange2", "lagrange3", "hermite"}) {
    what.set_scheme(scheme);
    expect_order(what, GetParam().coarsest, 2);
  }
}

using enum Schedule::Kind;

// Seen in x1 slowest-first, where the coupling errs a hundred times less than the integrator.
TEST(IntegratorOrder, OfRungeKuttaIsFourBesideAReconstructionOfOrderFive) {
  TwoMassRun what = run_at(3.0, slowest_first);
  what.fast = real_fast();
  what.set_scheme("lagrange4");
  expect_order_of_x1(what, 160, 4);
}

INSTANTIATE_TEST_SUITE_P(Real, IntegratorOrders,
                         testing::Values(Place{slowest_first, 3, 160}, Place{fastest_first, 3, 160},
                                         Place{parallel, 3, 160}, Place{slowest_first, 7.3, 640},
                                         Place{fastest_first, 7.3, 640}, Place{parallel, 7.3, 640}),
                         place_name);

}  // namespace
}  // namespace tandem::test
