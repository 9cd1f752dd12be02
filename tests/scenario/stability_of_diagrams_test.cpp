// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Diagrams that give their states, and such that remember more.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

#include "long_run.hpp"
#include "refusal.hpp"
#include "scratch.hpp"
#include "tandem/stability/modes.hpp"

namespace tandem::stability_of_diagrams_tests {
namespace {

using namespace test;

/// spring: what is as long as it; blocks: more of them.
std::string diagram(double stiffness, const std::string& spring = "x", const std::string& blocks = "") {
  return "[inputs]\nF = { unit = \"1\" }\n[blocks]\nv = { kind = \"integrator\", input = \"a\" }\n"
         "x = { kind = \"integrator\", input = \"v\", initial = 1 }\n" +
         blocks + "a = { kind = \"sum\", inputs = [\"F\", \"" + spring + "\", \"v\"], gains = [1, " +
         std::to_string(-stiffness) + ", -0.1] }\n[outputs]\nx = { unit = \"1\" }\nv = { unit = \"1\" }\n";
}

scenario::Scenario diagrams(const Scratch& folder, const std::string& soft) {
  folder.write("soft.toml", soft);
  folder.write("stiff.toml", diagram(9.0));
  return scenario::read(folder.write("s.toml", R"toml([subsystems.soft]
source = "diagram:soft.toml"
parameters = { step = 0.06 }
[subsystems.stiff]
source = "diagram:stiff.toml"
parameters = { step = 0.02 }
[[connections]]
from = "soft.x"
to = "stiff.F"
reconstruction = "lagrange2"
[[connections]]
from = "stiff.v"
to = "soft.F"
reconstruction = "lagrange2"
[coordination]
start = "cold"
[span]
stop = 1
)toml"));
}

TEST(Stability, DiagramsOfContinuousBlocksGiveTheirStates) {
  const Scratch folder;
  const auto one = diagrams(folder, diagram(1.0));
  const SuperStep step = stability::super_step(one, sources());
  EXPECT_TRUE(step.linear);
  const LongRun run(one, step, 14);
  const VectorXd from = run.at(11), to = run.at(12);
  EXPECT_LE((step.map * from - to).norm(), 1e-12 * to.norm());
  const auto found = stability::stability(one, sources());
  ASSERT_EQ(found.modes.size(), 2U);
  Eigen::Matrix4d rates;  // soft.x, soft.v, stiff.x, stiff.v
  rates << 0, 1, 0, 0, -1, -0.1, 0, 1, 0, 0, 0, 1, 1, 0, -9, -0.1;
  const Eigen::Vector4cd exact = rates.eigenvalues();
  for (const auto& mode : found.modes) {
    double nearest = 1.0;
    for (const auto& p : exact)
      nearest = std::min(nearest, std::abs(std::abs(p.imag()) / (2.0 * std::numbers::pi) - mode.frequency) +
                                      std::abs(-p.real() / std::abs(p) - mode.damping));
    EXPECT_LT(nearest, 1e-7);
  }
}

/// Two masses and a spring between them, which may go anywhere: the map has a multiplier of 1 twice, and what it errs by
/// takes these apart by its root. It is stable for short steps and not for long ones all the same.
TEST(Stability, WhatNothingHoldsMayGoOn) {
  const Scratch folder;
  const auto mass = [&](const std::string& name) {
    auto text = diagram(4.0);
    folder.write(name + ".toml", text.replace(text.find("-0.1"), 4, "-0.0"));
  };
  mass("soft"), mass("stiff");
  const auto with_steps = [&](double soft, double stiff) {
    return scenario::read(folder.write(
        "s.toml",
        fmt::format("[subsystems.soft]\nsource = 'diagram:soft.toml'\nparameters = {{ step = {} }}\n"
                    "[subsystems.stiff]\nsource = 'diagram:stiff.toml'\nparameters = {{ step = {} }}\n"
                    "[[connections]]\nfrom = 'soft.x'\nto = 'stiff.F'\ngain = 4\n"
                    "reconstruction = 'lagrange3'\n"
                    "[[connections]]\nfrom = 'stiff.x'\nto = 'soft.F'\ngain = 4\n"
                    "reconstruction = 'lagrange3'\n[coordination]\nstart = 'cold'\n[span]\nstop = 1\n",
                    soft, stiff)));
  };
  const auto found = stability::stability(with_steps(0.02, 0.01), sources());
  ASSERT_EQ(found.unknown, "");
  EXPECT_EQ(found.step.at_rest, 2);
  ASSERT_EQ(found.modes.size(), 1U);
  EXPECT_NEAR(found.modes[0].frequency, std::sqrt(8.0) / (2.0 * std::numbers::pi), 1e-7);
  for (const double step : {0.005, 0.02, 0.5}) {
    const auto shorter = stability::stability(with_steps(step, 0.5 * step), sources());
    EXPECT_NEAR(shorter.radius, 1.0, 1e-12) << step;
    EXPECT_FALSE(shorter.is_unstable()) << step;
  }
  EXPECT_TRUE(stability::stability(with_steps(0.7, 0.35), sources()).is_unstable());
}

/// A delay is no state that it gives; a linear model has the samples that it holds.
TEST(Stability, OfDiagramsThatRememberMoreALinearModelStands) {
  const Scratch folder;
  const auto one =
      diagrams(folder, diagram(1.0, "late", "late = { kind = \"delay\", input = \"x\", delay = 0.12 }\n"));
  const SuperStep step = stability::super_step(one, sources());
  ASSERT_EQ(step.identified.size(), 1U);
  EXPECT_EQ(step.identified[0].name, "soft");
  EXPECT_GT(step.identified[0].order, 2);
  EXPECT_LT(step.identified[0].residual, 1e-4);
  EXPECT_TRUE(step.linear);
}

}  // namespace
}  // namespace tandem::stability_of_diagrams_tests
