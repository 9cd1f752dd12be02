// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "part_step.hpp"

#include <unsupported/Eigen/MatrixFunctions>

#include "courses.hpp"

namespace tandem::identification {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr Index degree_terms = static_cast<Index>(places.size());

/// [A, sum of B_j, e; 0, 1].
MatrixXd whole_step(const LinearModel& model) {
  const Index n = model.order(), inputs = model.inputs.size();
  MatrixXd all = MatrixXd::Identity(n + inputs + 1, n + inputs + 1);
  all.topLeftCorner(n, n) = model.a;
  all.col(n + inputs).head(n) = model.e;
  for (Index i = 0; i < inputs; ++i)
    all.col(n + i).head(n) = model.b.middleCols(i * degree_terms, degree_terms).rowwise().sum();
  return all;
}

}  // namespace

PartSteps::PartSteps(const LinearModel& model) : states_(model.order()), inputs_(model.inputs.size()) {
  constexpr double precision = 1e-8;
  const MatrixXd whole = whole_step(model);
  if (states_ == 0) {
    rates_ = MatrixXd(0, inputs_ + 1);
    return;
  }
  const MatrixXd rates = whole.log();
  if (rates.allFinite() && (rates.exp() - whole).norm() <= precision * whole.norm())
    rates_ = rates.topRows(states_) / model.step;
}

/// In parts of s each input is a chain q0' = q1, q1' = q2, .. with qk = k! times its coefficient of degree k.
PartStep PartSteps::of(double length) const {
  const Index last = states_ + inputs_ * degree_terms, size = last + 1;
  MatrixXd rates = MatrixXd::Zero(size, size);
  rates.topLeftCorner(states_, states_) = length * rates_->leftCols(states_);
  rates.col(last).head(states_) = length * rates_->col(states_ + inputs_);
  MatrixXd to_chain = MatrixXd::Zero(inputs_ * degree_terms, inputs_ * degree_terms);
  for (Index i = 0; i < inputs_; ++i) {
    const Index first = states_ + i * degree_terms;
    rates.col(first).head(states_) = length * rates_->col(states_ + i);
    for (Index k = 0; k + 1 < degree_terms; ++k) rates(first + k, first + k + 1) = 1.0;
    Courses chain = courses();
    double factorial = 1.0;
    for (Index k = 1; k < degree_terms; ++k) chain.row(k) *= factorial *= static_cast<double>(k);
    to_chain.block(i * degree_terms, i * degree_terms, degree_terms, degree_terms) = chain;
  }
  const MatrixXd moved = rates.exp();
  return {moved.topLeftCorner(states_, states_),
          moved.block(0, states_, states_, inputs_ * degree_terms) * to_chain, moved.col(last).head(states_)};
}

}  // namespace tandem::identification
