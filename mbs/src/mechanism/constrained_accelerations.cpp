// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "constrained_accelerations.hpp"

#include <Eigen/SparseCholesky>
#include <cmath>
#include <limits>

#include "tandem/error.hpp"

namespace tandem::mbs {
namespace {

using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

constexpr double penalty_of_gradients = 1e8;
constexpr double small_correction = 1e-8;  // of the accelerations without constraints
constexpr int most_refinements = 30;

Sparse sparse_of(const Pattern& p, const std::vector<double>& values) {
  return Eigen::Map<const Sparse>(p.rows(), p.columns(), p.size(), p.starts().data(), p.indices().data(),
                                  values.data());
}

/// By 1 / sqrt(M_ii), so that masses are 1 on the diagonal; what has none goes by the geometric mean of the others.
VectorXd scales_of(const Sparse& mass) {
  const VectorXd diagonal = mass.diagonal();
  double sum = 0.0, count = 0.0;
  for (const double m : diagonal)
    if (m > 0.0) sum += std::log(m), ++count;
  const double mean = count > 0.0 ? std::exp(sum / count) : 1.0;
  return diagonal.unaryExpr([mean](double m) { return 1.0 / std::sqrt(m > 0.0 ? m : mean); });
}

}  // namespace

class ConstrainedAccelerations::Solver {
 public:
  void set(const Sparse& mass, const Sparse& gradients) {
    scales_ = scales_of(mass);
    mass_ = scales_.asDiagonal() * mass * scales_.asDiagonal();
    gradients_ = scales_.asDiagonal() * gradients;
    for (Eigen::Index c = 0; c < gradients_.cols(); ++c)
      if (const double norm = gradients_.col(c).norm(); norm > 0.0) gradients_.col(c) /= norm;
    Sparse still(mass.rows(), mass.cols());  // what has neither mass nor equation is accelerated by nothing
    still.reserve(Eigen::VectorXi::Constant(mass.cols(), 1));
    const Sparse matrix = mass_ + penalty_of_gradients * Sparse(gradients_ * gradients_.transpose());
    for (int i = 0; i < matrix.rows(); ++i) still.insert(i, i) = matrix.coeff(i, i) == 0.0 ? 1.0 : 0.0;
    const Sparse whole = matrix + still;
    if (!analysed_) solver_.analyzePattern(whole), analysed_ = true;
    solver_.factorize(whole);
  }

  VectorXd accelerations(const VectorXd& b) const {
    const VectorXd push = scales_.cwiseProduct(b);
    VectorXd x = VectorXd::Zero(b.size()), lambda = VectorXd::Zero(gradients_.cols());
    double before = std::numeric_limits<double>::infinity();
    for (int k = 0; k < most_refinements && solver_.info() == Eigen::Success; ++k) {
      const VectorXd off = -(gradients_.transpose() * x);
      const VectorXd dx =
          solver_.solve(push - mass_ * x - gradients_ * lambda + penalty_of_gradients * (gradients_ * off));
      const double size = dx.norm();
      if (size <= small_correction * push.norm() && !(size < 0.5 * before)) return scales_.cwiseProduct(x);
      if (!(size < 2.0 * before)) break;
      before = size;
      x += dx, lambda += penalty_of_gradients * (gradients_.transpose() * dx - off);
    }
    throw Error(ErrorCode::numerical,
                "an accelerance can't be told where the mechanism stands: its masses or its "
                "equations are too far apart in size");
  }

 private:
  VectorXd scales_;
  Sparse mass_, gradients_;
  bool analysed_ = false;
  Eigen::SimplicialLDLT<Sparse> solver_;
};

ConstrainedAccelerations::ConstrainedAccelerations(const Model& model)
    : model_(model),
      solver_(std::make_unique<Solver>()),
      jacobian_(static_cast<std::size_t>(model.structure().jacobian_values())),
      phi_(model.structure().constraints) {}

ConstrainedAccelerations::~ConstrainedAccelerations() = default;

void ConstrainedAccelerations::stand_at(const VectorXd& q) {
  const Structure& s = model_.structure();
  model_.constraints(q.data(), phi_.data(), jacobian_.data());
  solver_->set(sparse_of(s.mass.pattern, s.mass.values), sparse_of(s.jacobian, jacobian_));
}

VectorXd ConstrainedAccelerations::of(const VectorXd& b) const { return solver_->accelerations(b); }

}  // namespace tandem::mbs
