// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Mechanisms that differ in their size alone, under weights that differ as much, move alike.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tandem/mbs/make_stepper.hpp"
#include "tandem/mbs/mechanism/initial.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/trajectory.hpp"

namespace tandem::mbs {
namespace {

/// Twice as large with size = 2: angles over time stay what they are.
Description sized(Description d, double size) {
  d.gravity *= size;
  for (Entity& e : d.entities) e.at *= size, e.velocity *= size;
  for (Body& b : d.bodies) b.centre *= size, b.inertia *= size * size;
  for (Given& g : d.velocities) g.value *= size;
  return d;
}

/// At 0.5 s, in units of the size.
Eigen::VectorXd end(const Description& description, double size, const StepperSettings& settings) {
  Mechanism m(sized(description, size));
  return trajectory(m, initial_state(m, 0.0), settings, 1e-3, 500).q.bottomRows(1).transpose() / size;
}

class SizeOfMechanism : public testing::TestWithParam<StepperNames> {};

/// Of points alone.
TEST_P(SizeOfMechanism, IsNoMatterToItsMotion) {
  StepperSettings settings;
  settings.formulation = GetParam().formulation;
  settings.integrator = GetParam().integrator;
  for (const char* file : {"double_pendulum/double_pendulum.toml", "four_bar/four_bar.toml"}) {
    const Description d =
        read_mechanism(std::filesystem::path(TANDEM_SOURCE_DIR) / "scenarios/mechanisms" / file);
    const Eigen::VectorXd expected = end(d, 1.0, settings);
    for (const double size : {1e-6, 1e-3, 1e3, 1e6})
      EXPECT_LT((end(d, size, settings) - expected).norm(), 1e-7) << file << ", size " << size;
  }
}

INSTANTIATE_TEST_SUITE_P(Mbs, SizeOfMechanism, testing::ValuesIn(stepper_names()),
                         [](const auto& p) { return p.param.formulation + "_" + p.param.integrator; });

}  // namespace
}  // namespace tandem::mbs
