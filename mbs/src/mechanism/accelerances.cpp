// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "accelerances.hpp"

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

/// What takes forces to accelerations, where a mechanism stands: coordinates scaled to masses of 1, gradients to a length
/// of 1.
class Accelerances::Solver {
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

  /// Throws Error(numerical) if they can't be told.
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

Accelerances::Accelerances(const Mechanism& mechanism, const std::vector<Output>& outputs)
    : mechanism_(mechanism),
      solver_(std::make_unique<Solver>()),
      jacobian_(static_cast<std::size_t>(mechanism.structure().jacobian_values())) {
  for (const Output& o : outputs) {
    places_.push_back(all_.size());
    if (o.kind == Output::Kind::accelerance)
      all_.push_back({mechanism.numbering().of(o.coordinate), o.input});
  }
  for (auto* one : {&values_, &rates_, &after_}) one->resize(all_.size());
}

Accelerances::~Accelerances() = default;

void Accelerances::find(const State& s) {
  if (!all_.empty()) find(s.q, values_);
}

/// Over a millionth of the mechanism's unit on either side: of parts as large errors by curvature of 1e-12, by rounding of
/// 1e-9.
void Accelerances::find_rates(const State& s) {
  const double speed = all_.empty() ? 0.0 : s.v.lpNorm<Eigen::Infinity>();
  std::fill(rates_.begin(), rates_.end(), 0.0);
  if (!(speed > 0.0)) return;
  const double by = 1e-6 * mechanism_.structure().unit() / speed;
  find(s.q + by * s.v, after_), find(s.q - by * s.v, rates_);
  for (std::size_t k = 0; k < all_.size(); ++k) rates_[k] = (after_[k] - rates_[k]) / (2.0 * by);
}

void Accelerances::find(const VectorXd& q, std::vector<double>& to) {
  const Structure& s = mechanism_.structure();
  VectorXd phi(s.constraints);
  mechanism_.constraints(q.data(), phi.data(), jacobian_.data());
  const Sparse mass = sparse_of(s.mass.pattern, s.mass.values), gradients = sparse_of(s.jacobian, jacobian_);
  solver_->set(mass, gradients);
  for (std::size_t k = 0; k < all_.size(); ++k)
    to[k] = all_[k].coordinate < s.variables
                ? solver_->accelerations(push(all_[k].input, q))[all_[k].coordinate]
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
