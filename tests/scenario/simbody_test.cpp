// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What tandem bench simbody compares: the linkage by Simbody and by tandem, both against the exact motion.
#if TANDEM_HAS_SIMBODY
#include <gtest/gtest.h>

#include "bench/linkage_methods.hpp"
#include "four_bar/integrate.hpp"
#include "refusal.hpp"
#include "simbody/linkage.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem {
namespace {

using four_bar::Course;
using four_bar::Start;
using simbody::Closing;

struct Swing {
  Start start;
  double end;  // [s]
};
constexpr Swing swings[] = {{Start::upright, 0.5}, {Start::hanging, 2.0}};

double error(const Course& course, int loops, const Swing& swing) {
  EXPECT_EQ(status(course), "ok") << course.reason;
  return rms_error(course, four_bar::exact_path(loops, swing.start, swing.end / 200, 200), swing.end / 200);
}

/// An error of 1e-8 in each of up to 100 steps, which grows by cosh(3.4 * 0.5) < 3 at most.
TEST(Simbody, FollowsTheLinkageInBothOfItsForms) {
  for (const int loops : {1, 3})
    for (const Swing& swing : swings)
      for (const Closing closing : {Closing::rod, Closing::point_on_line}) {
        const simbody::Linkage linkage(loops, swing.start, closing);
        const Course course = linkage.run({"RungeKuttaMerson", 1e-8}, swing.end);
        ASSERT_LE(course.knots.size(), 101u);
        EXPECT_LT(error(course, loops, swing), 3e-6) << loops;
      }
}

TEST(Simbody, TakesFixedStepsWhereTheyAreAskedFor) {
  const simbody::Linkage linkage(2, Start::hanging, Closing::rod);
  for (const char* integrator : {"RungeKuttaMerson", "RungeKutta3", "Verlet", "SemiExplicitEuler2"}) {
    const Course course = linkage.run({integrator, 1e-3, 1e-10, 1.0 / 64.0}, 1.0);
    ASSERT_EQ(course.knots.size(), 65u) << integrator;
    for (std::size_t k = 0; k < 65; ++k)
      EXPECT_NEAR(course.knots[k].time, static_cast<double>(k) / 64.0, 1e-12);
  }
}

TEST(Simbody, IsGivenUpWhenPatienceEnds) {
  const simbody::Linkage linkage(1, Start::hanging, Closing::rod);
  const Course course = linkage.run({"RungeKuttaMerson", 1e-3, 0.0, 0.0, 1e-9}, 20.0);
  EXPECT_EQ(course.ended, Course::Ended::given_up);
  EXPECT_NE(status(course).find("given up at "), std::string::npos);
}

TEST(Simbody, RefusesAnIntegratorThatIsNotThere) {
  const simbody::Linkage linkage(1, Start::hanging, Closing::rod);
  EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument, {"'RungeKutta5'", "RungeKuttaMerson"},
                            [&] { linkage.run({"RungeKutta5"}, 1.0); }));
}

/// The trapezoidal rule is late by (w h)^2/12 of the time, w < 3.5 rad/s: with h = 2 ms at 2 s 8.2e-6 s, at
/// up to 1 m/s.
TEST(Simbody, IsComparedWithStepsOfTandemThatFollowTheLinkageToo) {
  for (const Swing& swing : swings) {
    mbs::Mechanism linkage(mbs::read_mechanism("linkage", four_bar::text(3, swing.start)));
    const auto stepper = mbs::make_stepper(linkage, {});
    EXPECT_LT(error(four_bar::integrate(linkage, *stepper, swing.end, 1000), 3, swing), 8.2e-6);
  }
}

TEST(Simbody, IsBenchmarkedWithMethodsThatAllRunFromTheirCoarsestSetting) {
  const bench::LinkageMotion motion{"hanging", Start::hanging, 0.2};
  const bench::LinkageMethods methods(motion, 1);
  ASSERT_GT(methods.all().size(), 10u);
  for (const auto& method : methods.all())
    EXPECT_EQ(status(method.run(method.settings.front(), 10.0)), "ok") << method.name;
}

}  // namespace
}  // namespace tandem
#endif
