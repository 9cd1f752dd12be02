// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Mechanisms in the map of a super-step: their independent coordinates and rates are its states.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "long_run.hpp"
#include "refusal.hpp"
#include "scratch.hpp"
#include "tandem/stability/modes.hpp"
#include "two_mass/model.hpp"

namespace tandem::stability_of_mechanisms_tests {
namespace {

using namespace test;

/// A rod that swings, and a diagram that pulls at its end with a spring; both give their states as outputs.
scenario::Scenario pendulum(const Scratch& folder, double angle, const std::string& formulation) {
  folder.write("rod.toml", fmt::format(R"toml(dimension = 2
gravity = [0, -9.81]
[points]
O = {{ at = [0, 0], fixed = true }}
P = {{ at = [{:.17g}, {:.17g}] }}
[rods]
rod = {{ points = ["O", "P"], mass = 2 }}
[masses]
end = {{ point = "P", mass = 0.5 }}
[inputs]
F = {{ unit = "N", value = 0 }}
[forces]
pull = {{ point = "P", direction = [1, 0], magnitude = "F" }}
[outputs]
"P.x" = {{ position = "P.x" }}
"P.x_rate" = {{ velocity = "P.x" }}
[run]
step = 0.01
formulation = "{}"
integrator = "newmark"
)toml",
                                       std::sin(angle), -std::cos(angle), formulation));
  folder.write("pull.toml", R"toml([inputs]
x = { unit = "m" }
[blocks]
v = { kind = "integrator", input = "a" }
y = { kind = "integrator", input = "v" }
a = { kind = "sum", inputs = ["x", "y", "v"], gains = [3, -3, -0.2] }
F = { kind = "sum", inputs = ["y", "x"], gains = [3, -3] }
[outputs]
y = { unit = "m" }
v = { unit = "m/s" }
F = { unit = "N" }
)toml");
  return scenario::read(folder.write("s.toml", R"toml([subsystems.rod]
source = "mechanism:rod.toml"
[subsystems.pull]
source = "diagram:pull.toml"
parameters = { step = 0.005 }
[[connections]]
from = "rod.P.x"
to = "pull.x"
reconstruction = "lagrange0"
[[connections]]
from = "pull.F"
to = "rod.F"
reconstruction = "lagrange0"
[coordination]
start = "cold"
[span]
stop = 1
)toml"));
}

TEST(Stability, AMechanismMovesAboutItsStartAsTheMapSays) {
  const Scratch folder;
  constexpr double angle = 0.4, by = 1e-5;
  for (const auto& [formulation, most] :
       {std::pair("index3", 1e-7), {"null_space", 1e-7}, {"penalty", 1e-6}}) {
    const SuperStep step = stability::super_step(pendulum(folder, angle, formulation), sources());
    EXPECT_FALSE(step.linear);
    const LongRun above(pendulum(folder, angle + by, formulation), step, 2),
        below(pendulum(folder, angle - by, formulation), step, 2);
    const VectorXd from = above.at(0) - below.at(0), to = above.at(1) - below.at(1);
    EXPECT_LE((step.map * from - to).norm(), most * to.norm()) << formulation;
  }
}

TEST(Stability, ModesOfARodAreThoseOfItsEquation) {
  const Scratch folder;
  const auto found = stability::stability(pendulum(folder, 0.0, "index3"), sources());
  ASSERT_EQ(found.modes.size(), 2U);
  // about its middle (m L^2/3 + M L^2) phi'' = -(m/2 + M) g L phi + 3 (y - L phi) L; y'' = 3 (x - y) - 0.2 y'
  const double inertia = 2.0 / 3.0 + 0.5, torque = 1.5 * 9.81;
  Eigen::Matrix4d rates;
  rates << 0, 1, 0, 0, -(torque + 3.0) / inertia, 0, 3.0 / inertia, 0, 0, 0, 0, 1, 3, 0, -3, -0.2;
  const Eigen::Vector4cd exact = rates.eigenvalues();
  for (const auto& mode : found.modes) {
    double nearest = 1.0;
    for (const auto& p : exact)
      nearest = std::min(nearest, std::abs(std::abs(p.imag()) / 6.283185307179586 - mode.frequency) +
                                      std::abs(-p.real() / std::abs(p) - mode.damping));
    EXPECT_LT(nearest, 1e-5) << mode.frequency << ' ' << mode.damping;
  }
}

/// Mass 2 of the two-mass test on a spring of 100 m.
TEST(Stability, TheTwoMassTestWithAMechanismHasTheSameMap) {
  const Scratch folder;
  for (const double ratio : {3.0, 25.0}) {
    const two_mass::Model model(two_mass::Settings{.frequency_ratio = ratio});
    folder.write("slow.toml", fmt::format(R"toml(dimension = 2
[points]
wall = {{ at = [-100, 0], fixed = true }}
P = {{ at = [0, 0] }}
[masses]
m2 = {{ point = "P", mass = {:.17g} }}
[springs]
k = {{ points = ["wall", "P"], stiffness = {:.17g}, free = 100 }}
[inputs]
x1 = {{ unit = "m", value = 0 }}
[forces]
push = {{ point = "P", direction = [1, 0], magnitude = "x1", gain = {:.17g} }}
[outputs]
x2 = {{ position = "P.x" }}
)toml",
                                          model.m2, model.k2 + model.k3, model.k2));
    const std::string file = folder.write("s.toml", fmt::format(R"toml([subsystems.fast]
source = "builtin:two_mass.fast"
parameters = {{ frequency_ratio = {0} }}
[subsystems.slow]
source = "mechanism:slow.toml"
parameters = {{ step = {1:.17g} }}
[[connections]]
from = "slow.x2"
to = "fast.x2"
reconstruction = "lagrange2"
[[connections]]
from = "fast.x1"
to = "slow.x1"
reconstruction = "lagrange2"
[span]
stop = 10
)toml",
                                                                ratio, model.h2));
    const SuperStep found = stability::super_step(scenario::read(file), sources());
    const SuperStep expected = stability::super_step(
        scene("two_mass/two_mass.toml",
              {fmt::format("parameters.frequency_ratio={}", ratio), "coordination.schedule=slowest-first",
               "connections.reconstruction=lagrange2"}),
        sources());
    const Eigen::VectorXcd there = found.map.eigenvalues();
    for (const auto& one : expected.map.eigenvalues()) {
      double nearest = 1.0;
      for (const auto& other : there) nearest = std::min(nearest, std::abs(one - other));
      EXPECT_LT(nearest, 1e-5) << ratio;  // central differences, and eigenvalues that nearly meet
    }
  }
}

/// A reaction by samples of a motion that it prescribes: runs are stable, and differences say nothing.
TEST(Stability, DifferencesThatDoNotSettleAreRefused) {
  EXPECT_TRUE(refuses(ErrorCode::not_supported, {"pair.toml", "does not settle"}, [] {
    stability::super_step(scene("split_pendulum/pair.toml", {"subsystems.taker.parameters.step=5e-4",
                                                             "subsystems.giver.parameters.step=5e-5"}),
                          sources());
  }));
}

}  // namespace
}  // namespace tandem::stability_of_mechanisms_tests
