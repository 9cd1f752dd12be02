// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Each formulation with each integrator on mechanisms in space, of points and unit vectors.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/QR>

#include "mechanisms/rotor.hpp"
#include "mechanisms/spatial_slider_crank.hpp"
#include "stepper_errors.hpp"
#include "tandem/mbs/make_stepper.hpp"
#include "tandem/mbs/mechanism/mechanism.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/sparse/products.hpp"

namespace tandem::mbs {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

MatrixXd dense_matrix(const Pattern& pattern, const double* values) {
  MatrixXd result = MatrixXd::Zero(pattern.rows(), pattern.columns());
  const auto entries = pattern.entries();
  for (std::size_t k = 0; k < entries.size(); ++k) result(entries[k].first, entries[k].second) = values[k];
  return result;
}

/// Accelerations and the shortest multipliers that go with positions and velocities:
///   M a + Phi_q^T lambda = Q,  Phi_q a + gamma = 0.
void complete(Mechanism& m, State& s) {
  const Structure& structure = m.structure();
  const int n = structure.variables, c = structure.constraints;
  VectorXd phi(c), gamma(c), values(structure.jacobian_values()), force(n);
  m.at_time(s.time);
  m.constraints(s.q.data(), phi.data(), values.data());
  m.constraint_accelerations(s.q.data(), s.v.data(), gamma.data());
  m.forces(s.q.data(), s.v.data(), force.data());
  MatrixXd matrix = MatrixXd::Zero(n + c, n + c);
  matrix.topLeftCorner(n, n) = dense_matrix(structure.mass.pattern, structure.mass.values.data());
  matrix.topRightCorner(n, c) = dense_matrix(structure.jacobian, values.data());
  matrix.bottomLeftCorner(c, n) = matrix.topRightCorner(n, c).transpose();
  VectorXd right(n + c);
  right << force, -gamma;
  const VectorXd x = matrix.completeOrthogonalDecomposition().solve(right);
  s.a.head(n) = x.head(n);
  s.lambda = x.tail(c);
}

/// Puts a point or vector of the description, by its name.
void place(const Mechanism& m, State& s, const std::string& name, const Vector3d& at, const Vector3d& rate) {
  const auto& all = m.description().entities;
  for (std::size_t e = 0; e < all.size(); ++e)
    if (all[e].name == name) {
      s.q.segment<3>(m.coordinate(static_cast<int>(e))) = at;
      s.v.segment<3>(m.coordinate(static_cast<int>(e))) = rate;
    }
}

void place_rotor(const Mechanism& m, State& s) {
  const auto [axes, w] = mechanisms::rotor(s.time);
  for (int k = 0; k < 3; ++k)
    place(m, s, "e" + std::to_string(k + 1), axes.col(k), w.cross(Vector3d(axes.col(k))));
}

/// n is across the rod and the axis c that it shares with the universal joint.
void place_slider_crank(const Mechanism& m, State& s) {
  const auto at = mechanisms::spatial_slider_crank(s.time);
  const Vector3d w = at.rod_angular_velocity, n = (at.slider - at.crank_end).cross(at.cross).normalized();
  place(m, s, "B", at.crank_end, at.crank_end_velocity);
  place(m, s, "C", at.slider, at.slider_velocity);
  place(m, s, "c", at.cross, w.cross(at.cross));
  place(m, s, "n", n, w.cross(n));
}

class SpatialMechanism : public testing::TestWithParam<StepperNames> {
 protected:
  static double order() { return test::order_of(GetParam().integrator); }
  static StepperSettings settings() {
    StepperSettings named;
    named.formulation = GetParam().formulation;
    named.integrator = GetParam().integrator;
    if (named.formulation == "index3") named.index3.tolerance = 1e-12;
    return named;
  }

  /// Errors are taken at eight times; steps: a multiple of eight.
  static void expect_order(const std::string& name, void (*place)(const Mechanism&, State&), double end,
                           int steps, const StepperSettings& settings) {
    Mechanism m(read_mechanism(std::filesystem::path(TANDEM_SOURCE_DIR) / "scenarios/mechanisms" / name /
                               (name + ".toml")));
    std::vector<State> exact(9, m.described_state());
    for (std::size_t k = 0; k < exact.size(); ++k) {
      exact[k].time = end * static_cast<double>(k) / 8.0;
      place(m, exact[k]);
      complete(m, exact[k]);
    }
    const State first = exact.front();
    exact.erase(exact.begin());
    const auto errors = [&](int count) {
      return test::errors(*make_stepper(m, settings), first, exact, count);
    };
    test::expect_order(errors(steps), errors(2 * steps), order());
  }
};

INSTANTIATE_TEST_SUITE_P(Each, SpatialMechanism, testing::ValuesIn(stepper_names()),
                         [](const auto& p) { return p.param.formulation + "_" + p.param.integrator; });

/// Order 8 shows in long steps, but of penalty in short ones with a firm omega.
TEST_P(SpatialMechanism, IsMovedWithTheOrderOfItsStepperIfItIsARotor) {
  StepperSettings those = settings();
  if (order() < 8.0) return expect_order("rotor", place_rotor, 0.25, order() > 2.0 ? 16 : 128, those);
  const bool penalty = those.formulation == "penalty";
  if (penalty) those.penalty.omega = 300.0;
  expect_order("rotor", place_rotor, penalty ? 0.25 : 1.0, 32, those);
}

/// Order 4 shows where a formulation's own error is below the method's: with the default penalty of index1,
/// 2e7, multipliers are rounded at 1e-7, and Phi = lambda/(alpha omega^2) of penalty leaves 4e-8 m with its
/// omega of 10 rad/s.
TEST_P(SpatialMechanism, IsMovedWithTheOrderOfItsStepperIfItIsASliderCrank) {
  StepperSettings those = settings();
  const bool index1 = those.formulation == "index1", penalty = those.formulation == "penalty";
  if (order() > 2.0 && index1) those.index1.penalty = 1e4;
  if (order() > 2.0 && penalty) those.penalty.omega = 300.0;
  double end = 0.125;  // [s]
  int steps = order() == 2.0 ? 64 : penalty ? 128 : 32;
  if (order() == 8.0) end = index1 ? 0.16 : penalty ? 0.125 : 0.5, steps = index1 ? 8 : penalty ? 16 : 128;
  expect_order("spatial_slider_crank", place_slider_crank, end, steps, those);
}

}  // namespace
}  // namespace tandem::mbs
