// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "accelerances.hpp"

#include <Eigen/SparseCholesky>
#include <cmath>

namespace tandem::mbs {
namespace {

using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

constexpr double penalty = 1e9;  // by the largest mass and the mean square of a gradient
constexpr int most_refinements = 20;

Sparse sparse_of(const Pattern& p, const std::vector<double>& values) {
  return Eigen::Map<const Sparse>(p.rows(), p.columns(), p.size(), p.starts().data(), p.indices().data(),
                                  values.data());
}

/// What takes forces to accelerations, where a mechanism stands.
class KktSolver {
 public:
  KktSolver(const Sparse& mass, const Sparse& gradients) : mass_(mass), gradients_(gradients) {
    const double of_mass = mass.coeffs().size() > 0 ? mass.coeffs().abs().maxCoeff() : 1.0;
    const double of_gradient =
        gradients.squaredNorm() / std::max<double>(1.0, static_cast<double>(gradients.cols()));
    alpha_ = of_gradient > 0.0 ? penalty * of_mass / of_gradient : 0.0;
    Sparse matrix = mass + alpha_ * Sparse(gradients * gradients.transpose());
    Sparse still(matrix.rows(),
                 matrix.cols());  // what has neither mass nor equation is accelerated by nothing
    still.reserve(Eigen::VectorXi::Constant(matrix.cols(), 1));
    for (int i = 0; i < matrix.rows(); ++i)
      if (matrix.coeff(i, i) == 0.0) still.insert(i, i) = 1.0;
    solver_.compute(Sparse(matrix + still));
  }

  VectorXd accelerations(const VectorXd& b) const {
    VectorXd x = VectorXd::Zero(b.size()), lambda = VectorXd::Zero(gradients_.cols());
    double before = std::numeric_limits<double>::infinity();
    for (int k = 0; k < most_refinements; ++k) {
      const VectorXd off = -(gradients_.transpose() * x);
      const VectorXd dx = solver_.solve(b - mass_ * x - gradients_ * lambda + alpha_ * (gradients_ * off));
      const double size = dx.norm();
      if (!(size < 0.5 * before)) break;
      before = size;
      x += dx, lambda += alpha_ * (gradients_.transpose() * dx - off);
    }
    return x;
  }

 private:
  const Sparse &mass_, &gradients_;
  double alpha_ = 0.0;
  Eigen::SimplicialLDLT<Sparse> solver_;
};

}  // namespace

Accelerances::Accelerances(const Mechanism& mechanism, const std::vector<Output>& outputs)
    : mechanism_(mechanism), jacobian_(static_cast<std::size_t>(mechanism.structure().jacobian_values())) {
  for (const Output& o : outputs) {
    places_.push_back(all_.size());
    if (o.kind == Output::Kind::accelerance)
      all_.push_back({mechanism.numbering().of(o.coordinate), o.input});
  }
  for (auto* one : {&values_, &rates_, &after_}) one->resize(all_.size());
}

void Accelerances::find(const State& s) {
  if (!all_.empty()) find(s.q, values_);
}

/// Over a hundred-thousandth of the mechanism's unit on either side: errors by curvature of 1e-10, by rounding of 1e-10.
void Accelerances::find_rates(const State& s) {
  const double speed = all_.empty() ? 0.0 : s.v.lpNorm<Eigen::Infinity>();
  std::fill(rates_.begin(), rates_.end(), 0.0);
  if (!(speed > 0.0)) return;
  const double by = 1e-5 * mechanism_.structure().unit() / speed;
  find(s.q + by * s.v, after_), find(s.q - by * s.v, rates_);
  for (std::size_t k = 0; k < all_.size(); ++k) rates_[k] = (after_[k] - rates_[k]) / (2.0 * by);
}

void Accelerances::find(const VectorXd& q, std::vector<double>& to) {
  const Structure& s = mechanism_.structure();
  VectorXd phi(s.constraints);
  mechanism_.constraints(q.data(), phi.data(), jacobian_.data());
  const Sparse mass = sparse_of(s.mass.pattern, s.mass.values), gradients = sparse_of(s.jacobian, jacobian_);
  const KktSolver solver(mass, gradients);
  for (std::size_t k = 0; k < all_.size(); ++k)
    to[k] = all_[k].coordinate < s.variables
                ? solver.accelerations(push(all_[k].input, q))[all_[k].coordinate]
                : 0.0;
}

/// The generalised forces of an input of 1.
VectorXd Accelerances::push(int input, const VectorXd& q) const {
  const Description& in = mechanism_.description();
  VectorXd b = VectorXd::Zero(q.size());
  for (const Force& f : in.forces) {
    if (f.input != input) continue;
    const int d = in.dimension;
    if (f.kind == Force::Kind::relative) {
      b[mechanism_.numbering().relative[static_cast<std::size_t>(f.index)]] += f.gain;
    } else if (f.kind == Force::Kind::point) {
      b.segment(mechanism_.coordinate(f.index), d) += f.gain * f.direction.head(d);
    } else {
      const int from = mechanism_.coordinate(f.points.from), to = mechanism_.coordinate(f.points.to);
      const VectorXd apart = f.gain * (q.segment(to, d) - q.segment(from, d)).normalized();
      b.segment(from, d) -= apart, b.segment(to, d) += apart;
    }
  }
  return b.head(mechanism_.structure().variables);
}

}  // namespace tandem::mbs
