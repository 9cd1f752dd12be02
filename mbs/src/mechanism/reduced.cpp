// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/reduced.hpp"

#include <algorithm>
#include <utility>

#include "../dense.hpp"
#include "linear_forces.hpp"
#include "tandem/error.hpp"

namespace tandem::mbs {
namespace {

using dense::MatrixXd;
using Eigen::VectorXd;

constexpr double moves_by_itself = 1e-3;  // part of its motion that others do not have
constexpr int most_iterations = 30;

/// Rows of motions, less what those that are taken have of each.
class Rest {
 public:
  explicit Rest(MatrixXd rows) : whole_(rows.rowwise().norm()), rows_(std::move(rows)) {}
  double part(int row) const { return whole_[row] > 0.0 ? rows_.row(row).norm() / whole_[row] : 0.0; }
  double size(int row) const { return rows_.row(row).norm(); }
  void take(int row) {
    const Eigen::RowVectorXd direction = rows_.row(row).normalized();
    rows_ -= (rows_ * direction.transpose()) * direction;
  }

 private:
  VectorXd whole_;
  MatrixXd rows_;
};

}  // namespace

std::vector<int> independent_variables(const Model& model, const VectorXd& q, const std::vector<int>& wanted,
                                       const std::vector<int>& liked) {
  DenseTerms terms(model);
  terms.evaluate(q, VectorXd::Zero(q.size()));
  const MatrixXd free = free_motions(terms.gradients);
  Rest rest(free);
  std::vector<int> all;
  const auto take = [&](int row) { rest.take(row), all.push_back(row); };
  for (const int row : wanted) {
    if (rest.part(row) < moves_by_itself) return {};
    take(row);
  }
  for (const int row : liked)
    if (static_cast<Eigen::Index>(all.size()) < free.cols() && rest.part(row) >= moves_by_itself) take(row);
  while (static_cast<Eigen::Index>(all.size()) < free.cols()) {
    int largest = 0;
    for (int row = 1; row < free.rows(); ++row)
      if (rest.size(row) > rest.size(largest)) largest = row;
    take(largest);
  }
  return all;
}

/// Phi_q x = b, with given values in the rows of p.
class Reduced::Equations {
 public:
  explicit Equations(const Model& model) : terms(model) {}
  void set(const std::vector<int>& variables) {
    const auto m = terms.gradients.cols(), n = terms.gradients.rows();
    MatrixXd rows = MatrixXd::Zero(m + static_cast<Eigen::Index>(variables.size()), n);
    lengths_ = terms.gradients.colwise().norm().transpose().unaryExpr(
        [](double one) { return one > 0.0 ? one : 1.0; });
    for (Eigen::Index c = 0; c < m; ++c) rows.row(c) = terms.gradients.col(c).transpose() / lengths_[c];
    for (std::size_t k = 0; k < variables.size(); ++k)
      rows(m + static_cast<Eigen::Index>(k), variables[k]) = 1.0;
    qr_.setThreshold(1e-9);
    qr_.compute(rows);
    if (qr_.rank() < n)
      throw Error(
          ErrorCode::numerical,
          "the mechanism stands where its coordinates do not follow from those of its links and its relative "
          "ones; a relative coordinate that always tells how it stands would do");
  }
  VectorXd solve(const VectorXd& b, const VectorXd& p) const {
    VectorXd right(b.size() + p.size());
    right << b.cwiseQuotient(lengths_), p;
    return dense::solve(qr_, right);
  }
  DenseTerms terms;

 private:
  VectorXd lengths_;
  dense::Qr qr_;
};

Reduced::Reduced(const Model& model, std::vector<int> variables, VectorXd q)
    : model_(model),
      variables_(std::move(variables)),
      q_(std::move(q)),
      equations_(std::make_unique<Equations>(model)),
      mass_(DenseTerms(model).mass()) {}

Reduced::~Reduced() = default;

void Reduced::stand_at(const VectorXd& p) {
  const auto n = static_cast<Eigen::Index>(variables_.size()),
             all = static_cast<Eigen::Index>(model_.structure().variables);
  Equations& e = *equations_;
  const VectorXd still = VectorXd::Zero(q_.size()), stay = VectorXd::Zero(n);
  VectorXd moved = VectorXd::Zero(n);
  for (Eigen::Index k = 0; k < n; ++k) moved[k] = p[k] - q_[variables_[static_cast<std::size_t>(k)]];
  double before = 0.0;
  for (int k = 0;; ++k) {
    e.terms.evaluate(q_, still), e.set(variables_);
    const VectorXd step = e.solve(-e.terms.phi, k == 0 ? moved : stay);
    const double size = step.norm();
    q_.head(all) += step;
    if (k > 1 && (size <= 1e-15 * q_.norm() || (size <= 1e-9 * q_.norm() && !(size < 0.5 * before)))) break;
    if (k == most_iterations)
      throw Error(ErrorCode::numerical, "the mechanism's constraints can't be closed from where it stood");
    before = size;
  }
  r_.resize(all, n);
  const VectorXd none = VectorXd::Zero(e.terms.phi.size());
  for (Eigen::Index k = 0; k < n; ++k) r_.col(k) = e.solve(none, VectorXd::Unit(n, k));
  reduced_mass_ = dense::reduced(mass_, r_);
}

VectorXd Reduced::rates(const VectorXd& u) {
  VectorXd of_time(equations_->terms.phi.size());
  model_.constraint_rates(q_.data(), of_time.data());
  return r_ * u + equations_->solve(-of_time, VectorXd::Zero(u.size()));
}

VectorXd Reduced::accelerations(const VectorXd& u) {
  Equations& e = *equations_;
  VectorXd gamma(e.terms.phi.size()), v = VectorXd::Zero(q_.size());
  v.head(r_.rows()) = rates(u);
  model_.constraint_accelerations(q_.data(), v.data(), gamma.data());
  e.terms.evaluate(q_, v);
  const VectorXd s = e.solve(-gamma, VectorXd::Zero(u.size()));
  return answer(r_.transpose() * (e.terms.force - mass_ * s));
}

VectorXd Reduced::answer(const VectorXd& b) const { return dense::solve_by_lu(reduced_mass_, b); }

}  // namespace tandem::mbs
