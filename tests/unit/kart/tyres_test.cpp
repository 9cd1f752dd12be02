// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "kart/tyres.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tandem/error.hpp"

namespace tandem::kart {
namespace {

constexpr TyreLaw laws[] = {TyreLaw::linear, TyreLaw::magic_formula, TyreLaw::tmeasy};
constexpr Axle axles[] = {Axle::front, Axle::rear};

TEST(Tyres, HaveNoForceWithoutSlipOrLoad) {
  for (const TyreLaw law : laws)
    for (const Axle axle : axles)
      for (const TyreForce& f :
           {tyre_force(law, axle, {0.0, 0.0}, 700.0), tyre_force(law, axle, {0.1, -0.2}, 0.0),
            tyre_force(law, axle, {0.1, -0.2}, -5.0)}) {
        EXPECT_EQ(f.longitudinal, 0.0);
        EXPECT_EQ(f.lateral, 0.0);
      }
}

TEST(Tyres, AreOddInBothSlips) {
  for (const TyreLaw law : laws)
    for (const Axle axle : axles) {
      const TyreForce one = tyre_force(law, axle, {0.04, 0.07}, 600.0),
                      other = tyre_force(law, axle, {-0.04, -0.07}, 600.0);
      EXPECT_EQ(one.longitudinal, -other.longitudinal);
      EXPECT_EQ(one.lateral, -other.lateral);
    }
}

/// By hand at 896 N: K = 20 x 896 N, and 37.6 x 896 sin(2 atan(1 / 1.6)) N at the rear, 34.1 at the front.
TEST(Tyres, MagicFormulaHasItsSlopes) {
  const double by = 1e-7, turn = std::sin(2.0 * std::atan(1.0 / 1.6));
  const auto slope = [&](Axle axle, const Slip& slip) {
    const TyreForce f = tyre_force(TyreLaw::magic_formula, axle, slip, 896.0);
    return (f.longitudinal + f.lateral) / by;
  };
  EXPECT_NEAR(slope(Axle::rear, {by, 0.0}), 17920.0, 1e-2);
  EXPECT_NEAR(slope(Axle::front, {by, 0.0}), 17920.0, 1e-2);
  EXPECT_NEAR(slope(Axle::rear, {0.0, by}), 37.6 * 896.0 * turn, 1e-2);
  EXPECT_NEAR(slope(Axle::front, {0.0, by}), 34.1 * 896.0 * turn, 1e-2);
}

/// Its sine is 1 there.
TEST(Tyres, MagicFormulaPeaksAtTheGrip) {
  double most = 0.0, most_lateral = 0.0;
  for (double s = 0.0; s < 0.4; s += 1e-5) {
    most = std::max(most, tyre_force(TyreLaw::magic_formula, Axle::rear, {s, 0.0}, 757.0).longitudinal);
    most_lateral =
        std::max(most_lateral, tyre_force(TyreLaw::magic_formula, Axle::rear, {0.0, s}, 757.0).lateral);
  }
  EXPECT_NEAR(most, 0.9 * 757.0, 1e-4);
  EXPECT_NEAR(most_lateral, 1.5 * 757.0, 1e-4);
}

/// sqrt((24.7 s / 0.9)^2 + (37 s / 1.5)^2) = 1 where it begins to slide.
TEST(Tyres, LinearSaturatesOnAnEllipse) {
  const TyreForce rolling = tyre_force(TyreLaw::linear, Axle::rear, {0.01, -0.01}, 500.0);
  EXPECT_DOUBLE_EQ(rolling.longitudinal, 123.5);
  EXPECT_DOUBLE_EQ(rolling.lateral, -185.0);
  const TyreForce sliding = tyre_force(TyreLaw::linear, Axle::rear, {0.5, -0.3}, 500.0);
  EXPECT_NEAR(std::hypot(sliding.longitudinal / 450.0, sliding.lateral / 750.0), 1.0, 1e-14);
  EXPECT_DOUBLE_EQ(tyre_force(TyreLaw::linear, Axle::rear, {1.0, 0.0}, 500.0).longitudinal, 450.0);
}

TEST(Tyres, TmeasyPassesThroughItsTable) {
  const auto force = [](double s, double load) {
    return tyre_force(TyreLaw::tmeasy, Axle::rear, {s, 0.0}, load).longitudinal;
  };
  EXPECT_NEAR(force(1e-8, 470.0) / 1e-8, 11640.0, 1e-2);
  EXPECT_NEAR(force(0.086, 470.0), 423.0, 1e-9);
  EXPECT_NEAR(force(0.6, 470.0), 285.0, 1e-9);
  EXPECT_NEAR(force(0.9, 940.0), 611.0, 1e-9);
  EXPECT_NEAR(force(0.0975, 705.0), 634.5, 1e-9);  // between both: the mean
  EXPECT_NEAR(force(1e-8, 705.0) / 1e-8, 0.5 * (11640.0 + 18390.0), 1e-2);
  EXPECT_NEAR(force(0.086, 235.0), 211.5, 1e-9);
}

/// Up to the peak TMeasy is within 5.5 % of the grip of what it was fitted to (loads between).
TEST(Tyres, TmeasyFollowsTheMagicFormula) {
  for (const Axle axle : axles)
    for (const double load : {470.0, 757.0, 940.0})
      for (double s = 0.0; s < 0.12; s += 0.005) {
        const TyreForce a = tyre_force(TyreLaw::tmeasy, axle, {s, 0.0}, load),
                        b = tyre_force(TyreLaw::magic_formula, axle, {s, 0.0}, load),
                        c = tyre_force(TyreLaw::tmeasy, axle, {0.0, s}, load),
                        d = tyre_force(TyreLaw::magic_formula, axle, {0.0, s}, load);
        EXPECT_NEAR(a.longitudinal, b.longitudinal, 0.055 * 0.9 * load) << load << ' ' << s;
        EXPECT_NEAR(c.lateral, d.lateral, 0.055 * 1.5 * load) << load << ' ' << s;
      }
}

TEST(Tyres, ShareTheirGripAmongDirections) {
  for (const TyreLaw law : laws)
    for (const Axle axle : axles) {
      const TyreForce pure = tyre_force(law, axle, {0.08, 0.0}, 600.0),
                      both = tyre_force(law, axle, {0.08, 0.1}, 600.0);
      EXPECT_LT(both.longitudinal, pure.longitudinal);
      EXPECT_LT(both.lateral, tyre_force(law, axle, {0.0, 0.1}, 600.0).lateral);
      EXPECT_LE(std::hypot(both.longitudinal, both.lateral), 1.5 * 600.0);
    }
}

TEST(Tyres, UnknownLawIsRefusedByName) { EXPECT_THROW(tyre_law("pacejka"), Error); }

}  // namespace
}  // namespace tandem::kart
