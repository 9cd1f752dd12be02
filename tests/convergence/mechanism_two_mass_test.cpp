// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The two-mass test with mass 2 as a mechanism, beside the one whose trapezoidal rule is solved exactly.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/subsystem.hpp"
#include "two_mass_run.hpp"

namespace tandem::test {
namespace {

/// A point mass on a spring to a wall 100 m away; the partner's displacement acts through k2, or its force as it
/// is.
MakeSide mechanism(Crossing crossing) {
  return [crossing](const two_mass::Model& model) {
    const bool force = crossing == Crossing::force_from_fast;
    const two_mass::Motion start = model.exact(0.0);
    const std::string text = fmt::format(
        "dimension = 2\n[points]\nwall = {{ at = [-100, 0], fixed = true }}\n"
        "P = {{ at = [{:.17g}, 0], velocity = [{:.17g}, 0] }}\n[masses]\nm2 = {{ point = 'P', mass = {:.17g} }}\n"
        "[springs]\nk = {{ points = ['wall', 'P'], stiffness = {:.17g}, free = 100 }}\n"
        "[inputs]\n{} = {{ unit = '{}' }}\n"
        "[forces]\npush = {{ point = 'P', direction = [1, 0], magnitude = '{}', gain = {:.17g} }}\n"
        "[outputs]\nx2 = {{ position = 'P.x' }}\nv2 = {{ velocity = 'P.x' }}\n",
        start.x2, start.v2, model.m2, force ? model.k3 : model.k2 + model.k3, force ? "F" : "x1",
        force ? "N" : "m", force ? "F" : "x1", force ? 1.0 : model.k2);
    mbs::SubsystemSettings settings{model.h2, {}};
    settings.stepper.index3.tolerance = 1e-13;
    return mbs::make_subsystem(mbs::read_mechanism("mass 2", text), settings);
  };
}

double largest_difference(const std::vector<Node>& a, const std::vector<Node>& b) {
  EXPECT_EQ(a.size(), b.size());
  double most = 0.0, size = 0.0;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
    most = std::max(most, std::abs(a[k].x - b[k].x));
    size = std::max(size, std::abs(b[k].x));
  }
  return most / size;
}

TEST(MechanismOfTheTwoMassTest, GivesTheNumbersOfTheExactRule) {
  for (const double ratio : {3.0, 25.0, 30.7})
    for (const auto schedule :
         {Schedule::Kind::slowest_first, Schedule::Kind::fastest_first, Schedule::Kind::parallel})
      for (const char* scheme : {"lagrange0", "lagrange3", "hermite"})
        for (const Crossing crossing : {Crossing::displacements, Crossing::force_from_fast}) {
          if (crossing == Crossing::force_from_fast && scheme == std::string("hermite")) continue;  // F has no rate
          TwoMassRun what = run_at(ratio, schedule);
          what.crossing = crossing;
          what.fast = real_fast(crossing == Crossing::force_from_fast);
          what.slow = real_slow(crossing == Crossing::force_from_fast);
          what.set_scheme(scheme);
          what.t_stop = 20.0;
          const TwoMassResult expected = run(what);
          what.slow = mechanism(crossing);
          const TwoMassResult found = run(what);
          EXPECT_LT(largest_difference(found.slow, expected.slow), 1e-9) << ratio << " " << scheme;
          EXPECT_LT(largest_difference(found.fast, expected.fast), 1e-9) << ratio << " " << scheme;
        }
}

}  // namespace
}  // namespace tandem::test
