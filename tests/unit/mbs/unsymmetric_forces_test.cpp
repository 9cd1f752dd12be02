// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "refusal.hpp"
#include "tandem/mbs/formulations/index3.hpp"

namespace tandem::mbs {
namespace {

/// A unit mass in the plane with Q = -100 q - 30 (y, -x): a force that circulates, as of a shaft in a bearing
/// with inner damping. K = [100 30; -30 100].
class Whirl final : public Model {
 public:
  Whirl() {
    structure_.coordinates = structure_.variables = 2;
    structure_.mass = {Pattern(2, 2, {{0, 0}, {1, 1}}), {1.0, 1.0}};
    structure_.jacobian = Pattern(2, 0, {});
    structure_.stiffness = Pattern(2, 2, {{0, 0}, {1, 0}, {0, 1}, {1, 1}});
    structure_.symmetric_forces = false;
    structure_.variable_names = {"x", "y"};
  }
  const Structure& structure() const override { return structure_; }
  void at_time(double) override {}
  void constraints(const double*, double*, double*) const override {}
  void constraint_rates(const double*, double*) const override {}
  void constraint_accelerations(const double*, const double*, double*) const override {}
  void forces(const double* q, const double*, double* force) const override {
    force[0] = -100.0 * q[0] - 30.0 * q[1];
    force[1] = 30.0 * q[0] - 100.0 * q[1];
  }
  void force_derivatives(const double*, const double*, double* k, double* c) const override {
    k[0] = k[3] = 100.0, k[1] = -30.0, k[2] = 30.0;
    std::fill_n(c, 4, 0.0);
  }
  double energy(const double*, const double*) const override { return 0.0; }

 private:
  Structure structure_;
};

State displaced() {
  State s;
  s.q = Eigen::Vector2d(1.0, 0.0);
  s.v = s.a = Eigen::Vector2d::Zero();
  s.lambda = Eigen::VectorXd();
  return s;
}

/// Forces are linear, so Newton's method has the solution after one iteration and sees it in the next; with
/// one triangle of K alone it would go on.
TEST(UnsymmetricForces, HaveTheirWholeTangent) {
  for (const std::string& solver : solver_names(MatrixKind::unsymmetric)) {
    Whirl whirl;
    Index3 stepper(whirl, {.solver = solver});
    State s = displaced();
    stepper.start(s);
    EXPECT_EQ(stepper.step(s, 0.1, 0.1), 2) << solver;
  }
}

TEST(UnsymmetricForces, AreRefusedByASolverForSymmetricMatrices) {
  Whirl whirl;
  EXPECT_TRUE(test::refuses(ErrorCode::invalid_argument, {"band", "unsymmetric"},
                            [&] { Index3(whirl, {.solver = "band"}); }));
}

}  // namespace
}  // namespace tandem::mbs
