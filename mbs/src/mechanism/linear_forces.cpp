// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "linear_forces.hpp"

#include "../dense.hpp"

namespace tandem::mbs {
namespace {

constexpr double part = 1e-6;  // of a unit: errors of 1e-12 by curvature, 1e-10 by rounding

/// The columns -d f/d x by central differences of f, which looks at x, of n numbers.
template <class Function>
Eigen::MatrixXd negative_derivative(Eigen::VectorXd& x, double by, int n, const Function& f) {
  Eigen::MatrixXd result(n, n);
  for (int column = 0; column < n; ++column) {
    const double middle = x[column];
    x[column] = middle + by;
    result.col(column) = -f();
    x[column] = middle - by;
    result.col(column) += f();
    x[column] = middle;
  }
  return result / (2.0 * by);
}

}  // namespace

DenseTerms::DenseTerms(const Model& model)
    : force(model.structure().variables),
      phi(model.structure().constraints),
      gradients(model.structure().variables, model.structure().constraints),
      model_(model),
      values_(static_cast<std::size_t>(model.structure().jacobian_values())) {}

void DenseTerms::evaluate(const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
  model_.forces(q.data(), v.data(), force.data());
  model_.constraints(q.data(), phi.data(), values_.data());
  gradients.setZero();
  const Pattern& p = model_.structure().jacobian;
  for (int column = 0; column < p.columns(); ++column)
    for (int k = p.starts()[column]; k < p.starts()[column + 1]; ++k)
      gradients(p.indices()[k], column) = values_[static_cast<std::size_t>(k)];
}

Eigen::MatrixXd DenseTerms::stiffness(const State& at) {
  Eigen::VectorXd q = at.q;
  return negative_derivative(q, part * model_.structure().unit(), static_cast<int>(force.size()), [&] {
    evaluate(q, at.v);
    return unbalanced(at.lambda);
  });
}

Eigen::MatrixXd DenseTerms::damping(const State& at) {
  Eigen::VectorXd v = at.v;
  return negative_derivative(v, part * model_.structure().unit(), static_cast<int>(force.size()), [&] {
    model_.forces(at.q.data(), v.data(), force.data());
    return force;
  });
}

Eigen::MatrixXd DenseTerms::mass() const {
  const Matrix& m = model_.structure().mass;
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(m.pattern.rows(), m.pattern.columns());
  for (int column = 0; column < m.pattern.columns(); ++column)
    for (int k = m.pattern.starts()[column]; k < m.pattern.starts()[column + 1]; ++k)
      result(m.pattern.indices()[k], column) = m.values[static_cast<std::size_t>(k)];
  return result;
}

Eigen::MatrixXd free_motions(const Eigen::MatrixXd& gradients) {
  const auto n = gradients.rows();
  if (gradients.cols() == 0) return Eigen::MatrixXd::Identity(n, n);
  Eigen::MatrixXd scaled = gradients;
  for (int c = 0; c < scaled.cols(); ++c) scaled.col(c).stableNormalize();
  dense::Qr qr(scaled);
  qr.setThreshold(1e-9);
  return dense::complement(qr);
}

}  // namespace tandem::mbs
