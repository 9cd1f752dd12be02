// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Sentences tell by how much a rod is too long, not what its equation (r^2 - l^2)/l leaves.
#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <string>

#include "driven_pendulum.hpp"
#include "refusal.hpp"
#include "tandem/mbs/formulations/index3.hpp"
#include "tandem/mbs/make_stepper.hpp"
#include "tandem/mbs/mechanism/initial.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::mbs {
namespace {

/// A rod of 2 mm that a spring pulls to half its length at once, with an angle beside it so that steppers go
/// by lengths (Structure::constraint_scales).
Mechanism pulled_rod() {
  return Mechanism(read_mechanism(
      "m",
      "dimension = 2\n[points]\nO = { at = [0, 0], fixed = true }\nP = { at = [2e-3, 0] }\n[vectors]\n"
      "e = { at = [1, 0], fixed = true }\n[angles]\nt = { from = 'e', to = ['O', 'P'] }\n[rods]\n"
      "r = { points = ['O', 'P'], mass = 1 }\n[springs]\n"
      "s = { points = ['O', 'P'], stiffness = 1e20, free = 1e-3 }\n"));
}

TEST(LostDistance, IsToldInMetres) {
  Mechanism m = pulled_rod();
  ASSERT_FALSE(m.structure().constraint_scales.empty());
  State s = initial_state(m, 0.0);
  const auto stepper = make_stepper(m, {});
  stepper->start(s);
  EXPECT_TRUE(test::refuses(
      ErrorCode::numerical,
      {"constraint 'body r: P . P' is lost at t = 0.001 s: it is off by -0.001 m, allowed is 1e-05 m"},
      [&] { stepper->step(s, 1e-3, 1e-3); }));
}

TEST(LostDistance, IsOffByTheDifferenceOfLengths) {
  const Mechanism m = pulled_rod();
  const Eigen::VectorXd q = m.described_state().q;
  const double l = 2e-3, r = 2.5e-3;
  EXPECT_NEAR(m.off(0, q.data(), (r * r - l * l) / l).now, r - l, 1e-18);
  EXPECT_NEAR(m.off(0, q.data(), -l).now, -l, 1e-18);
  EXPECT_EQ(m.off(0, q.data(), 0.0).per_phi, 0.5);
}

/// A penalty that holds nothing: the rod grows slowly, and is refused where it is off by 1e-5 of what is
/// allowed more than that.
TEST(LostConstraint, IsToldInFiguresThatDiffer) {
  test::DrivenPendulum pendulum({});
  Index3 formulation(pendulum, {.penalty = 1.0});
  State s = pendulum.at(0.0, 1.0, 0.5);
  formulation.start(s);
  std::string sentence;
  try {
    for (int k = 1; k <= 500000; ++k) formulation.step(s, 1e-6, 1e-6 * k);
  } catch (const Error& error) {
    sentence = error.what();
  }
  std::smatch figures;
  ASSERT_TRUE(std::regex_search(sentence, figures, std::regex("off by -?([^,]*), allowed is ([^;]*);")))
      << sentence;
  EXPECT_NE(figures[1], figures[2]);
  EXPECT_NEAR(std::stod(figures[1]), std::stod(figures[2]), 1e-4 * std::stod(figures[2]));
}

}  // namespace
}  // namespace tandem::mbs
