// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "linearized.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace tandem::mbs {
namespace {

using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

constexpr int most_closing_steps = 100, most_pushes = 3;

Eigen::Map<const Sparse> transposed(const Model& model, const std::vector<double>& values) {
  const Pattern& p = model.structure().jacobian;
  return {p.rows(), p.columns(), p.size(), p.starts().data(), p.indices().data(), values.data()};
}

/// Half of a step at a time until it makes things better; false, and q as it was, if no part of it does.
bool take(Linearized& at, VectorXd& q, const VectorXd& step) {
  const VectorXd before = q;
  const double error = at.phi.norm();
  for (int halvings = 0; halvings < 100 && step.squaredNorm() > 0.0; ++halvings) {
    q.head(step.size()) = before.head(step.size()) + std::ldexp(1.0, -halvings) * step;
    at.evaluate(q);
    if (at.phi.norm() < error) return true;
  }
  q = before;
  at.evaluate(q);
  return false;
}

/// Newton's method from q. Where it is stuck, q is pushed aside: a rod that is drawn level and whose x is
/// given has no gradient by the y that may move.
bool close(Linearized& at, VectorXd& q) {
  at.evaluate(q);
  if (largest(at.phi) <= 1e-3 * at.limit) return true;
  double before = at.phi.norm(), least = before;
  VectorXd nearest = q;
  for (int k = 0, pushes = 0; k < most_closing_steps; ++k) {
    const bool better = take(at, q, at.step(at.phi));
    const double now = at.phi.norm();
    if (!(now < 0.5 * before) && largest(at.phi) <= at.limit) return true;
    if (now < least) least = now, nearest = q;
    const bool stuck = !better || !(now < 0.99 * before);
    before = now;
    if (!stuck) continue;
    if (pushes++ == most_pushes) break;
    at.push(q, 0.1 * largest(at.phi));
    at.evaluate(q);
    before = at.phi.norm();
  }
  q = nearest;
  at.evaluate(q);
  return false;
}

}  // namespace

double largest(const VectorXd& x) {
  if (x.hasNaN()) return std::numeric_limits<double>::quiet_NaN();
  return x.size() > 0 ? x.lpNorm<Eigen::Infinity>() : 0.0;
}

Linearized::Linearized(Model& model, const std::vector<Known::Value>& known)
    : phi(model.structure().constraints),
      model_(model),
      values_(static_cast<std::size_t>(model.structure().jacobian_values())),
      stays_(static_cast<std::size_t>(model.structure().variables)) {
  for (const Known::Value& k : known)
    if (k.coordinate < variables()) stays_[static_cast<std::size_t>(k.coordinate)] = true;
}

VectorXd Linearized::rate(const VectorXd& v) const {
  return transposed(model_, values_).transpose() * v.head(variables());
}

/// (1 + alpha A A^T) d = -alpha A error, A the part of Phi_q^T that may move, alpha 1e10 by the mean square
/// of its columns.
VectorXd Linearized::step(const VectorXd& error) const {
  Sparse a = transposed(model_, values_);
  a.prune([&](Eigen::Index row, Eigen::Index, double) { return !stays_[static_cast<std::size_t>(row)]; });
  const double size = a.norm() / std::sqrt(std::max(1.0, static_cast<double>(a.cols())));
  if (!(size > 0.0)) return VectorXd::Zero(a.rows());
  a /= size;
  Sparse matrix = 1e10 * (a * Sparse(a.transpose())), one(a.rows(), a.rows());
  one.setIdentity();
  matrix += one;
  const Eigen::SimplicialLDLT<Sparse> solver(matrix);
  return -1e10 / size * solver.solve(a * error);
}

/// Parts from -1 to 1: the multiples of the golden section, which never repeat, less whole numbers.
void Linearized::push(VectorXd& q, double most) const {
  for (int i = 0; i < variables(); ++i) {
    const double multiple = 0.6180339887498949 * (i + 1);
    if (!stays_[static_cast<std::size_t>(i)]) q[i] += most * (2.0 * (multiple - std::floor(multiple)) - 1.0);
  }
}

/// Known positions are approached by parts of at most a quarter of the model's unit: an angle's equation has
/// a second solution half a turn away.
bool assemble(Linearized& at, VectorXd& q, const std::vector<Known::Value>& known) {
  const VectorXd from = q;
  constexpr double least = 1e-6;  // of its unit: where all coordinates are 0
  at.limit = tolerable(std::max(largest(q), least * at.unit()));
  double way = 0.0;
  for (const auto& k : known) way = std::max(way, std::abs(k.value - from[k.coordinate]));
  const int parts = static_cast<int>(std::clamp(std::ceil(4.0 * way / at.unit()), 1.0, 200.0));
  for (int part = 1; part < parts; ++part) {
    for (const auto& k : known)
      q[k.coordinate] = from[k.coordinate] + (k.value - from[k.coordinate]) * part / parts;
    if (!close(at, q)) break;
  }
  for (const auto& k : known) q[k.coordinate] = k.value;
  return close(at, q);
}

}  // namespace tandem::mbs
