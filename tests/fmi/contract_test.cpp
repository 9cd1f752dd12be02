// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "fmus.hpp"
#include "tandem/check.hpp"

namespace tandem::test {
namespace {

/// Inputs whose start value is not known stay as they are.
void expect_nothing_wrong(const std::string& name, const std::vector<double>& inputs) {
  for (const Finding& finding : check([&] { return open_fmu(name); }, {0.5, inputs}))
    EXPECT_NE(finding.kind, Finding::Kind::wrong)
        << name << ": " << finding.check << ": " << finding.sentence;
}

TEST(FmuContract, CoSimulationKeepsIt) {
  expect_nothing_wrong("decay", {});
  expect_nothing_wrong("decay?state=trust", {});
  for (const std::string held : {"mean", "left", "right", "middle", "derivatives"})
    expect_nothing_wrong("mass?type=cs&state=trust&lands=true&inputs=" + held, {std::nan("")});
  expect_nothing_wrong("types?type=cs&step=0.001", {0.0, 0.0, 1.0, 0.0, 1.0});
}

TEST(FmuContract, ModelExchangeKeepsIt) {
  expect_nothing_wrong("decay?type=me", {});
  expect_nothing_wrong("mass?type=me", {std::nan("")});
  expect_nothing_wrong("ball", {});
  expect_nothing_wrong("stair", {});
  expect_nothing_wrong("van_der_pol?type=me", {});
  expect_nothing_wrong("types?type=me&step=0.001", {0.0, 0.0, 1.0, 0.0, 1.0});
}

}  // namespace
}  // namespace tandem::test
