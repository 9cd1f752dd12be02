// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Models whose terms are written by hand, each against differences of its own functions. To put one to the
// test, add it to models().
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <functional>
#include <memory>

#include "driven_pendulum.hpp"
#include "four_bar/hand_written.hpp"
#include "pendulum.hpp"
#include "tandem/mbs/sparse/products.hpp"

namespace tandem::mbs {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Case {
  std::string name;
  std::function<std::unique_ptr<Model>()> make;
};
std::vector<Case> models() {
  return {{"driven_pendulum",
           [] { return std::make_unique<test::DrivenPendulum>(test::DrivenPendulum::Parameters{}); }},
          {"example", [] { return std::make_unique<example::Pendulum>(); }},
          {"four_bar", [] { return std::make_unique<four_bar::HandWritten>(3); }}};
}

/// Somewhere off the constraints, where derivatives hold too.
class HandWrittenModel : public testing::TestWithParam<Case> {
 protected:
  HandWrittenModel()
      : model_(GetParam().make()), s_(model_->structure()), q_(s_.coordinates), v_(s_.coordinates) {
    for (int i = 0; i < s_.coordinates; ++i) q_[i] = std::sin(1.3 * i + 0.4), v_[i] = 2.0 * std::cos(0.7 * i);
    model_->at_time(t_);
  }

  VectorXd phi(const VectorXd& q) const {
    VectorXd value(s_.constraints), jacobian(s_.jacobian_values());
    model_->constraints(q.data(), value.data(), jacobian.data());
    return value;
  }
  /// Phi_q x.
  VectorXd along(const VectorXd& q, const VectorXd& x) const {
    VectorXd value(s_.constraints), jacobian(s_.jacobian_values()), product(s_.constraints);
    model_->constraints(q.data(), value.data(), jacobian.data());
    multiply_transposed(s_.jacobian, jacobian.data(), x.data(), product.data());
    return product;
  }
  VectorXd rates(const VectorXd& q) const {
    VectorXd value(s_.constraints);
    model_->constraint_rates(q.data(), value.data());
    return value;
  }
  VectorXd force(const VectorXd& q, const VectorXd& v) const {
    VectorXd value(s_.variables);
    model_->forces(q.data(), v.data(), value.data());
    return value;
  }

  static constexpr double t_ = 0.7, d_ = 1e-5;
  std::unique_ptr<Model> model_;
  const Structure& s_;
  VectorXd q_, v_;
};
INSTANTIATE_TEST_SUITE_P(Each, HandWrittenModel, testing::ValuesIn(models()),
                         [](const auto& p) { return p.param.name; });

/// Functions are of second degree at most, but for the pivot in time (third derivatives below 30), so central
/// differences err by 1e-10 of those and by rounding, 1e-14/1e-5.
constexpr double close = 1e-8;

TEST_P(HandWrittenModel, HasTheJacobianOfItsConstraints) {
  const VectorXd difference = (phi(q_ + d_ * v_) - phi(q_ - d_ * v_)) / (2.0 * d_);
  EXPECT_LT((along(q_, v_) - difference).cwiseAbs().maxCoeff(), close);
}

TEST_P(HandWrittenModel, HasTheRatesOfItsConstraints) {
  const VectorXd there = rates(q_);
  model_->at_time(t_ + d_);
  const VectorXd after = phi(q_);
  model_->at_time(t_ - d_);
  EXPECT_LT((there - (after - phi(q_)) / (2.0 * d_)).cwiseAbs().maxCoeff(), close);
}

/// Phi' = Phi_q v + Phi_t, followed without acceleration.
TEST_P(HandWrittenModel, HasTheRestOfTheirSecondDerivative) {
  VectorXd gamma(s_.constraints);
  model_->constraint_accelerations(q_.data(), v_.data(), gamma.data());
  const auto rate = [&](double by) {
    model_->at_time(t_ + by);
    return VectorXd(along(q_ + by * v_, v_) + rates(q_ + by * v_));
  };
  const VectorXd after = rate(d_), before = rate(-d_);
  EXPECT_LT((gamma - (after - before) / (2.0 * d_)).cwiseAbs().maxCoeff(), close);
}

TEST_P(HandWrittenModel, HasTheDerivativesOfItsForces) {
  VectorXd k(s_.stiffness_values()), c(k);
  model_->force_derivatives(q_.data(), v_.data(), k.data(), c.data());
  VectorXd by_q(s_.variables), by_v(by_q);  // K and C times v
  Rows(s_.stiffness).multiply(k.data(), v_.data(), by_q.data());
  Rows(s_.stiffness).multiply(c.data(), v_.data(), by_v.data());
  const auto difference = [&](const VectorXd& q, const VectorXd& v) {
    return VectorXd((force(q_ + d_ * q, v_ + d_ * v) - force(q_ - d_ * q, v_ - d_ * v)) / (2.0 * d_));
  };
  const VectorXd none = VectorXd::Zero(v_.size());
  EXPECT_LT((by_q + difference(v_, none)).cwiseAbs().maxCoeff(), close);
  EXPECT_LT((by_v + difference(none, v_)).cwiseAbs().maxCoeff(), close);
}

/// Kinetic energy from the mass matrix, potential energy from the forces at rest.
TEST_P(HandWrittenModel, HasTheEnergyOfItsMassesAndForces) {
  VectorXd momentum(s_.variables);
  multiply_symmetric(s_.mass, v_.data(), momentum.data());
  const VectorXd none = VectorXd::Zero(v_.size()), f = force(q_, none);
  const auto energy = [&](const VectorXd& q, const VectorXd& v) {
    return model_->energy(q.data(), v.data());
  };
  EXPECT_NEAR(energy(q_, v_) - energy(q_, none), 0.5 * momentum.dot(v_), 1e-12);
  EXPECT_NEAR((energy(q_ + d_ * v_, none) - energy(q_ - d_ * v_, none)) / (2.0 * d_), -f.dot(v_), close);
}

}  // namespace
}  // namespace tandem::mbs
