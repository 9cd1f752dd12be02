// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Angles beside the edges that they belong to, where each step turns the two by a little more or less.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "refusal.hpp"
#include "tandem/mbs/make_stepper.hpp"
#include "tandem/mbs/mechanism/initial.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::mbs {
namespace {

/// A rod of 1 m, and its angle from a fixed edge. Variables: P.x, P.y, t.
std::string wheel(double rate, const std::string& more = "") {
  return "dimension = 2\n[points]\nO = { at = [0, 0], fixed = true }\nP = { at = [1, 0], velocity = [0, " +
         std::to_string(rate) +
         "] }\n[vectors]\ne = { at = [1, 0], fixed = true }\n[rods]\nr = { points = ['O', 'P'], mass = 1 }\n"
         "[angles]\nt = { from = 'e', to = ['O', 'P'] }\n" +
         more;
}

struct Turned {
  double angle, off;  ///< at the end; the most that it was ahead of its edges or behind [rad]
};

Turned turn(const std::string& text, const StepperSettings& settings, double h, double end) {
  Mechanism m(read_mechanism("wheel", text));
  State s = initial_state(m, 0.0);
  const auto stepper = make_stepper(m, settings);
  stepper->start(s);
  Turned result{0.0, 0.0};
  for (long k = 1; k <= std::lround(end / h); ++k) {
    stepper->step(s, h, static_cast<double>(k) * h);
    const double off = std::remainder(s.q[2] - std::atan2(s.q[1], s.q[0]), 2.0 * std::numbers::pi);
    result = {s.q[2], std::max(result.off, std::abs(off))};
  }
  return result;
}

StepperSettings settings(const char* formulation, const char* integrator) {
  StepperSettings s;
  s.formulation = formulation, s.integrator = integrator;
  return s;
}

constexpr const char* stabilized[] = {"penalty", "index1"};
constexpr double held = 1e-3;  // [rad] a tenth of what is allowed

/// The trapezoidal rule turns the rod by 2 atan(w h/2) in a step and the angle by w h. What the edges lag
/// behind, d in a second, Baumgarte's terms leave off by 2 xi d/omega = d/5: 4.5e-4 rad here.
TEST(TurningAngle, IsOffByWhatBaumgartesTermsLeaveOfTheLag) {
  constexpr double w = 30.0, h = 1e-3, lag = w - 2.0 / h * 0.0149988751;  // atan(0.015)
  for (const char* formulation : stabilized)
    EXPECT_NEAR(turn(wheel(w), settings(formulation, "newmark"), h, 2.0).off, lag / 5.0, 0.01 * lag / 5.0)
        << formulation;
}

/// At 100 rad/s that would be 0.017 rad, and more with the midpoint rule: the angle is held a thousandth of
/// a radian beside its edges.
TEST(TurningAngle, IsHeldBesideItsEdgesWhereThatIsTooMuch) {
  for (const char* formulation : stabilized)
    for (const char* integrator : {"newmark", "rk2", "generalized_alpha"})
      EXPECT_LT(turn(wheel(100.0), settings(formulation, integrator), 1e-3, 2.0).off, 1.001 * held)
          << formulation << " " << integrator;
}

/// It has no mass, so the rod turns as the method lets it: behind by w h^2 w^2/12 in a second.
TEST(TurningAngle, TurnsWithItsEdgesWhereItIsHeld) {
  constexpr double w = 100.0, end = 2.0;
  for (const char* formulation : stabilized) {
    const auto behind = [&](double h) {
      return w * end - turn(wheel(w), settings(formulation, "newmark"), h, end).angle;
    };
    EXPECT_NEAR(behind(1e-3), end * w * w * w * 1e-6 / 12.0, 3e-3) << formulation;
    EXPECT_NEAR(std::log2(behind(1e-3) / behind(5e-4)), 2.0, 0.2) << formulation;
  }
}

/// Driven, it is the rod that is moved.
TEST(TurningAngle, TakesItsEdgesAlongWhereItIsDriven) {
  const std::string text = wheel(100.0,
                                 "[inputs]\nm = { unit = 'rad', polynomial = [0, 100] }\n"
                                 "[drives]\nd = { coordinate = 't', motion = 'm' }\n");
  for (const char* formulation : stabilized) {
    const Turned at = turn(text, settings(formulation, "newmark"), 1e-3, 2.0);
    EXPECT_LT(at.off, 1.001 * held) << formulation;
    EXPECT_NEAR(at.angle, 200.0, 1e-6) << formulation;
  }
}

/// At 600 rad/s the edges lag behind by w h - 2 atan(w h/2) = 0.017 rad in one step.
TEST(TurningAngle, IsLostWhereOneStepIsTooLong) {
  for (const char* formulation : stabilized)
    EXPECT_TRUE(test::refuses(ErrorCode::numerical,
                              {"constraint 'angle t' is lost at t = 0.001 s", "allowed is 0.01 rad"},
                              [&] { turn(wheel(600.0), settings(formulation, "newmark"), 1e-3, 1.0); }))
        << formulation;
}

}  // namespace
}  // namespace tandem::mbs
