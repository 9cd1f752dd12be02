// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "four_bar/hand_written.hpp"

#include <gtest/gtest.h>

#include "four_bar/linkage.hpp"
#include "tandem/mbs/formulations/index3.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::four_bar {
namespace {

class HandWrittenLinkage : public testing::TestWithParam<int> {
 protected:
  HandWrittenLinkage()
      : general_(mbs::read_mechanism("linkage", text(GetParam()))), hand_written_(GetParam()) {}

  /// Anywhere, fixed coordinates at rest: of the general one, then of the other.
  std::pair<Eigen::VectorXd, Eigen::VectorXd> velocities() const {
    Eigen::VectorXd all = Eigen::VectorXd::Zero(general_.structure().coordinates);
    for (int i = 0; i < variables(); ++i) all[i] = std::sin(1.7 * i);
    return {all, all.head(variables())};
  }
  std::pair<Eigen::VectorXd, Eigen::VectorXd> positions() const {
    Eigen::VectorXd all = general_.described_state().q;
    for (int i = 0; i < variables(); ++i) all[i] += 0.3 * std::sin(2.3 * i + 1.0);
    return {all, all.head(variables())};
  }
  int variables() const { return hand_written_.structure().variables; }

  mbs::Mechanism general_;
  HandWritten hand_written_;
};
INSTANTIATE_TEST_SUITE_P(Loops, HandWrittenLinkage, testing::Values(1, 2, 5, 40));

/// Masses of the general one come of a rod's moments about the drawing's origin, with their roundings.
TEST_P(HandWrittenLinkage, HasTheStructureOfTheGeneralOne) {
  const mbs::Structure &whole = general_.structure(), &own = hand_written_.structure();
  EXPECT_EQ(own.variable_names, whole.variable_names);
  EXPECT_EQ(own.constraint_names.size(), whole.constraint_names.size());
  EXPECT_EQ(own.jacobian, whole.jacobian);
  EXPECT_EQ(own.stiffness, whole.stiffness);
  ASSERT_EQ(own.mass.pattern, whole.mass.pattern);
  for (std::size_t k = 0; k < own.mass.values.size(); ++k)
    EXPECT_NEAR(own.mass.values[k], whole.mass.values[k], 1e-15 * (1 + GetParam() * GetParam())) << k;
}

TEST_P(HandWrittenLinkage, HasItsTermsToTheLastBit) {
  const auto [q, own_q] = positions();
  const auto [v, own_v] = velocities();
  const int m = hand_written_.structure().constraints, entries = hand_written_.structure().jacobian.size();
  Eigen::VectorXd phi(m), own_phi(m), jacobian(general_.structure().jacobian_values()), own_jacobian(entries),
      force(variables()), own_force(variables());
  general_.constraints(q.data(), phi.data(), jacobian.data());
  hand_written_.constraints(own_q.data(), own_phi.data(), own_jacobian.data());
  EXPECT_EQ(own_phi, phi);
  EXPECT_EQ(own_jacobian, jacobian.head(entries));
  general_.constraint_accelerations(q.data(), v.data(), phi.data());
  hand_written_.constraint_accelerations(own_q.data(), own_v.data(), own_phi.data());
  EXPECT_EQ(own_phi, phi);
  general_.constraint_rates(q.data(), phi.data());
  hand_written_.constraint_rates(own_q.data(), own_phi.data());
  EXPECT_EQ(own_phi, phi);
  general_.forces(q.data(), v.data(), force.data());
  hand_written_.forces(own_q.data(), own_v.data(), own_force.data());
  EXPECT_EQ(own_force, force);
  const double energy = general_.energy(q.data(), v.data());
  EXPECT_NEAR(hand_written_.energy(own_q.data(), own_v.data()), energy, 1e-14 * std::abs(energy) * m);
}

/// What roundings of masses and of places up to 40 m leave, and the flat position at 0.7 s enlarges: 1e-13.
TEST_P(HandWrittenLinkage, MovesAsTheGeneralOne) {
  const mbs::Index3Settings settings{.penalty = 1e8};
  mbs::Index3 first(general_, settings), second(hand_written_, settings);
  mbs::State s = general_.described_state(), r = hand_written_.first_state();
  first.start(s);
  second.start(r);
  for (int k = 1; k <= 1600; ++k) {
    first.step(s, 1.25e-3, 1.25e-3 * k);
    second.step(r, 1.25e-3, 1.25e-3 * k);
    ASSERT_LT((s.q.head(variables()) - r.q).cwiseAbs().maxCoeff(), 1e-12) << "at " << s.time << " s";
  }
}

}  // namespace
}  // namespace tandem::four_bar
