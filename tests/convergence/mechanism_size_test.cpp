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

bool is_length(const Description& d, const Coordinate& c) {
  return c.entity >= 0 ? is_point(d, c.entity) : !is_angle(d, c);
}

/// The length of an edge, of 1 for a vector's.
double by(const Edge& edge, double size) { return edge.from >= 0 ? size : 1.0; }

/// Twice as large with size = 2: angles over time stay what they are.
Description sized(Description d, double size) {
  d.gravity *= size;
  for (int e = 0; e < static_cast<int>(d.entities.size()); ++e)
    if (is_point(d, e)) d.entities[e].at *= size, d.entities[e].velocity *= size;
  for (Body& b : d.bodies) b.centre *= size, b.inertia *= size * size;
  for (ScalarProduct& p : d.products) p.value *= by(p.a, size) * by(p.b, size);
  for (Joint& j : d.joints) j.at *= size;
  for (Spring& s : d.springs) s.free *= size;
  for (auto* given : {&d.positions, &d.velocities})
    for (Given& g : *given) g.value *= is_length(d, g.coordinate) ? size : 1.0;
  return d;
}

/// At 0.1 s (`index1` loses Bricard's mechanism from 0.15 s on), lengths in units of the size.
Eigen::VectorXd end(const Description& description, double size, const StepperSettings& settings,
                    int steps = 100) {
  Mechanism m(sized(description, size));
  Eigen::VectorXd q =
      trajectory(m, initial_state(m, 0.0), settings, 0.1 / steps, steps).q.bottomRows(1).transpose();
  for (int e = 0; e < static_cast<int>(description.entities.size()); ++e)
    if (is_point(description, e)) q.segment(m.coordinate(e), description.dimension) /= size;
  for (std::size_t r = 0; r < description.relatives.size(); ++r)
    if (description.relatives[r].kind == Relative::Kind::length) q[m.numbering().relative[r]] /= size;
  return q;
}

class SizeOfMechanism : public testing::TestWithParam<StepperNames> {
 protected:
  StepperSettings settings() const {
    StepperSettings s;
    s.formulation = GetParam().formulation;
    s.integrator = GetParam().integrator;
    return s;
  }
  /// A size that is a power of 1024 leaves every digit but the last ones of constants; others change which
  /// coordinates null_space chooses and the penalty by up to 4 %: no more than twice the step does.
  void expect_alike(const std::string& name) {
    const Description d = read_mechanism(std::filesystem::path(TANDEM_SOURCE_DIR) / "scenarios/mechanisms" /
                                         name / (name + ".toml"));
    const Eigen::VectorXd expected = end(d, 1.0, settings());
    for (const double size : {0x1p-20, 0x1p-10, 0x1p10, 0x1p20})
      EXPECT_LT((end(d, size, settings()) - expected).norm(), 1e-12) << name << ", size " << size;
    const double own_error = (end(d, 1.0, settings(), 50) - expected).norm();
    for (const double size : {1e-6, 1e-3, 1e3, 1e6})
      EXPECT_LT((end(d, size, settings()) - expected).norm(), 1e-8 + own_error) << name << ", size " << size;
  }
};

TEST_P(SizeOfMechanism, IsNoMatterToTheMotionOfPoints) {
  for (const char* name : {"double_pendulum", "four_bar", "spherical_pendulum"}) expect_alike(name);
}

TEST_P(SizeOfMechanism, IsNoMatterBesideVectorsAndAngles) {
  for (const char* name : {"slider_crank", "rotor", "spatial_slider_crank", "bricard"}) expect_alike(name);
}

INSTANTIATE_TEST_SUITE_P(Mbs, SizeOfMechanism, testing::ValuesIn(stepper_names()),
                         [](const auto& p) { return p.param.formulation + "_" + p.param.integrator; });

}  // namespace
}  // namespace tandem::mbs
