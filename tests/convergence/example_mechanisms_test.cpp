// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Every mechanism of scenarios/mechanisms, from its file, against its truth.
#include <gtest/gtest.h>

#include <cmath>

#include "mechanisms/examples.hpp"
#include "tandem/mbs/formulations/index3.hpp"
#include "tandem/mbs/mechanism/initial.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::mechanisms {
namespace {

class ExampleMechanism : public testing::TestWithParam<Example> {
 protected:
  double error(int steps) const {
    const Example& e = GetParam();
    mbs::Mechanism m(mbs::read_mechanism(std::string(TANDEM_SOURCE_DIR) + "/scenarios/mechanisms/" + e.name +
                                         "/" + e.name + ".toml"));
    mbs::Index3 formulation(m, {.tolerance = 1e-12});
    mbs::State s = mbs::initial_state(m, 0.0);
    formulation.start(s);
    const double h = e.end / steps;
    for (int k = 1; k <= steps; ++k) formulation.step(s, h, h * k);
    return e.error(m, s);
  }
};
INSTANTIATE_TEST_SUITE_P(Each, ExampleMechanism, testing::ValuesIn(examples()),
                         [](const auto& p) { return p.param.name; });

TEST_P(ExampleMechanism, FollowsItsTruthWithOrderTwo) {
  const double coarse = error(GetParam().steps), fine = error(2 * GetParam().steps);
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.2) << coarse << " " << fine;
  EXPECT_LT(fine, 1e-4);
}

}  // namespace
}  // namespace tandem::mechanisms
