// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Mechanisms that differ in their size alone, under weights that differ as much, move alike.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tandem/error.hpp"
#include "tandem/mbs/make_stepper.hpp"
#include "tandem/mbs/mechanism/initial.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/mechanism/modes.hpp"
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

/// Lengths in units of the size.
Eigen::VectorXd in_sizes(const Mechanism& m, Eigen::VectorXd q, double size) {
  const Description& d = m.description();
  for (int e = 0; e < static_cast<int>(d.entities.size()); ++e)
    if (is_point(d, e)) q.segment(m.coordinate(e), d.dimension) /= size;
  for (std::size_t r = 0; r < d.relatives.size(); ++r)
    if (d.relatives[r].kind == Relative::Kind::length) q[m.numbering().relative[r]] /= size;
  return q;
}

/// At 0.1 s (`index1` loses Bricard's mechanism from 0.15 s on).
Eigen::VectorXd end(const Description& description, double size, const StepperSettings& settings,
                    int steps = 100) {
  Mechanism m(sized(description, size));
  return in_sizes(
      m, trajectory(m, initial_state(m, 0.0), settings, 0.1 / steps, steps).q.bottomRows(1).transpose(),
      size);
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

/// A plate of three points and a vector on three springs, drawn where it does not rest.
const std::string hung =
    "dimension = 3\ngravity = [0, 0, -9.81]\n[points]\n"
    "O = { at = [0, 0, 1], fixed = true }\nP = { at = [0.4, 0, 1], fixed = true }\n"
    "Q = { at = [0, 0.3, 1], fixed = true }\n"
    "A = { at = [0, 0, 0] }\nB = { at = [0.4, 0, 0] }\nC = { at = [0, 0.3, 0] }\n"
    "[vectors]\nw = { at = [0, 0, 1] }\n"
    "[bodies.plate]\npoints = ['A', 'B', 'C']\nvectors = ['w']\nmass = 2\ncentre = [0.15, 0.1, -0.05]\n"
    "inertia = [[0.02, 0, 0], [0, 0.03, 0], [0, 0, 0.04]]\n"
    "[springs]\na = { points = ['O', 'A'], stiffness = 200, damping = 4, free = 0.8 }\n"
    "b = { points = ['P', 'B'], stiffness = 300, damping = 4, free = 0.8 }\n"
    "c = { points = ['Q', 'C'], stiffness = 200, damping = 6, free = 0.9 }\n"
    "[initial]\nequilibrium = true\n";

/// Newton's method ends at 1e-10 of the forces at most; frequencies and damping are of differences over a
/// millionth of the power of 1024 next to the size.
TEST(SizeOfAMechanismOnSprings, IsNoMatterToItsEquilibriumAndItsModes) {
  const Description d = read_mechanism("hung", hung);
  Mechanism one(d);
  const State expected = initial_state(one, 0.0);
  const auto all = modes(one, expected);
  ASSERT_EQ(all.size(), 6U);
  for (const double size : {1e-6, 0x1p-20, 1e-3, 1e3, 0x1p20, 1e6}) {
    Mechanism m(sized(d, size));
    const State s = initial_state(m, 0.0);
    EXPECT_LT((in_sizes(m, s.q, size) - expected.q).norm(), 1e-9) << size;
    const auto found = modes(m, s);
    ASSERT_EQ(found.size(), all.size()) << size;
    for (std::size_t k = 0; k < all.size(); ++k)
      EXPECT_LT(std::abs(found[k].p - all[k].p), 1e-7 * std::abs(all[k].p)) << size << ", mode " << k;
  }
}

/// A rod that turns with 20 rad/s against a spring, which stands at an angle.
Description turning(double length) {
  return read_mechanism("turning",
                        fmt::format("dimension = 2\n[points]\nO = {{ at = [0, 0], fixed = true }}\n"
                                    "P = {{ at = [{0}, 0], velocity = [0, {1}] }}\n"
                                    "[vectors]\neast = {{ at = [1, 0], fixed = true }}\n"
                                    "[rods]\nrod = {{ points = ['O', 'P'], mass = 1 }}\n"
                                    "[angles]\nturn = {{ from = 'east', to = ['O', 'P'] }}\n"
                                    "[springs]\ns = {{ coordinate = 'turn', stiffness = {2}, free = 0.3 }}\n"
                                    "[initial]\nvelocities = {{ turn = 20 }}\n",
                                    length, 20.0 * length, 3000.0 * length * length));
}

/// What is thrown in the first second, steps of 30 ms.
std::string refused(double length, const Index3Settings& settings) {
  Mechanism m(turning(length));
  StepperSettings all;
  all.index3 = settings;
  try {
    trajectory(m, initial_state(m, 0.0), all, 0.03, 33);
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing";
}

TEST(SizeOfATurningRod, IsNoMatterToTheFrequencyThatLimitsTheStep) {
  const std::string expected = refused(1.0, {.beta = 1.0 / 12.0});
  EXPECT_NE(expected.find("the highest frequency"), std::string::npos) << expected;
  for (const double size : {0x1p-20, 0x1p20}) EXPECT_EQ(refused(size, {.beta = 1.0 / 12.0}), expected);
}

/// A hundredth of l in (r^2 - l^2)/l is a rod that is (sqrt(1.01) - 1) l too long.
TEST(SizeOfATurningRod, IsThatOfItsConstraintWhereItIsLost) {
  for (const auto& [length, allowed] :
       {std::pair{1e6, "allowed is 4.99e+03 m"}, {1e-6, "allowed is 4.99e-09 m"}}) {
    const std::string sentence = refused(length, {.penalty = 1.0, .tolerance = 1e6});
    EXPECT_NE(sentence.find("constraint 'body rod"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find(allowed), std::string::npos) << sentence;
  }
}

}  // namespace
}  // namespace tandem::mbs
