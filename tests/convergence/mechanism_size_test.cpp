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
  for (Entity& e : d.entities)
    if (e.kind == Entity::Kind::point) e.at *= size, e.velocity *= size;
  for (Body& b : d.bodies) b.centre *= size, b.inertia *= size * size;
  for (Joint& j : d.joints) j.at *= size;
  for (auto* given : {&d.positions, &d.velocities})  // of points, in the examples below
    for (Given& g : *given) g.value *= size;
  return d;
}

/// Of the points and vectors at 0.5 s, points in units of the size.
Eigen::VectorXd end(const Description& description, double size, const StepperSettings& settings) {
  Mechanism m(sized(description, size));
  const Trajectory t = trajectory(m, initial_state(m, 0.0), settings, 1e-3, 500);
  Eigen::VectorXd q = t.q.bottomRows(1).transpose();
  for (std::size_t e = 0; e < description.entities.size(); ++e)
    if (is_point(description, static_cast<int>(e)))
      q.segment(m.coordinate(static_cast<int>(e)), description.dimension) /= size;
  return q;
}

class SizeOfMechanism : public testing::TestWithParam<StepperNames> {};

TEST_P(SizeOfMechanism, IsNoMatterToItsMotion) {
  StepperSettings settings;
  settings.formulation = GetParam().formulation;
  settings.integrator = GetParam().integrator;
  for (const std::string name : {"double_pendulum", "spatial_slider_crank"}) {
    const std::string file =
        std::string(TANDEM_SOURCE_DIR) + "/scenarios/mechanisms/" + name + "/" + name + ".toml";
    const Description d = read_mechanism(std::filesystem::path(file));
    const Eigen::VectorXd expected = end(d, 1.0, settings);
    for (const double size : {1e-6, 1e-3, 1e3})
      EXPECT_LT((end(d, size, settings) - expected).norm(), 1e-7) << name << ", size " << size;
  }
}

INSTANTIATE_TEST_SUITE_P(Mbs, SizeOfMechanism, testing::ValuesIn(stepper_names()),
                         [](const auto& p) { return p.param.formulation + "_" + p.param.integrator; });

}  // namespace
}  // namespace tandem::mbs
