// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/formulations/null_space.hpp"

#include <algorithm>
#include <utility>

#include "../dense.hpp"
#include "check_memory.hpp"
#include "checks.hpp"
#include "settings.hpp"

namespace tandem::mbs {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

void fill(MatrixXd& dense, const Pattern& pattern, const double* values) {
  dense.setZero(pattern.rows(), pattern.columns());
  const auto entries = pattern.entries();
  for (std::size_t k = 0; k < entries.size(); ++k) dense(entries[k].first, entries[k].second) = values[k];
}

double last_pivot(const dense::Qr& qr, int rank) {
  return rank == 0 ? 1.0 : std::abs(qr.matrixR()(rank - 1, rank - 1));
}

}  // namespace

NullSpace::NullSpace(Model& model, const NullSpaceSettings& s)
    : model_(model),
      structure_(model.structure()),
      settings_(s),
      tolerance_(structure_.tolerance(s.tolerance, 1e-12)),
      jacobian_values_(static_cast<std::size_t>(structure_.jacobian_values())),
      most_off_(most_off(structure_)),
      phi_(structure_.constraints),
      force_(structure_.variables) {
  Setting{"null-space formulation", "tolerance", s.tolerance}.at_least(0.0, "a number above 0");
  Setting{"null-space formulation", "most_iterations", static_cast<double>(s.most_iterations)}.count();
  fill(mass_, structure_.mass.pattern, structure_.mass.values.data());
}

/// Phi and Phi_q of all variables.
void NullSpace::constraints() {
  MatrixXd gradients;
  model_.constraints(at_.q.data(), phi_.data(), jacobian_values_.data());
  fill(gradients, structure_.jacobian, jacobian_values_.data());
  jacobian_ = gradients.transpose();
}

/// True: other dependent variables than before. Precondition: constraints().
bool NullSpace::choose() {
  dense::Qr fresh(MatrixXd::Zero(1, structure_.variables));  // Eigen's need a row
  fresh.setThreshold(1e-9);
  if (structure_.constraints > 0) fresh.compute(jacobian_);
  const int rank = static_cast<int>(fresh.rank()), before = static_cast<int>(dependent_.size());
  if (chosen_ && rank != before)
    throw Error(
        ErrorCode::numerical,
        fmt::format("the rank of the Jacobian is {} at t = {} s and was {} before: dependent variables "
                    "can't be told there",
                    rank, at_.time, before));
  if (chosen_) {
    if (rank > 0) held_.compute(jacobian_(Eigen::all, dependent_));
    if (last_pivot(held_, rank) > 0.5 * last_pivot(fresh, rank)) return false;
  }
  const auto& order = fresh.colsPermutation().indices();
  dependent_.assign(order.data(), order.data() + rank);
  independent_.assign(order.data() + rank, order.data() + order.size());
  std::sort(dependent_.begin(), dependent_.end());
  std::sort(independent_.begin(), independent_.end());
  chosen_ = true;
  return true;
}

void NullSpace::recall(std::span<const double> memory) {
  for (const double i : memory) check_memory(i >= 0.0 && i < structure_.variables);
  dependent_.assign(memory.begin(), memory.end());
  independent_.clear();
  for (int i = 0; i < structure_.variables; ++i)
    if (!std::binary_search(dependent_.begin(), dependent_.end(), i)) independent_.push_back(i);
}

void NullSpace::solve_positions() {
  for (int k = 0; k < settings_.most_iterations; ++k) {
    constraints();
    if (dependent_.empty()) return;
    held_.compute(jacobian_(Eigen::all, dependent_));
    const VectorXd change = dense::solve(held_, phi_);
    at_.q(dependent_) -= change;
    if (change.norm() < tolerance_) return;
  }
  throw Error(
      ErrorCode::numerical,
      fmt::format("no convergence of the dependent variables at t = {} s in {} iterations; no shorter "
                  "step is tried",
                  at_.time, settings_.most_iterations));
}

void NullSpace::solve_velocities() {
  if (dependent_.empty()) return;
  VectorXd rate(structure_.constraints);
  model_.constraint_rates(at_.q.data(), rate.data());
  rate += jacobian_(Eigen::all, independent_) * at_.v(independent_);
  at_.v(dependent_) = -dense::solve(held_, rate);
}

void NullSpace::solve_accelerations() {
  const int n = structure_.variables, free = size();
  VectorXd gamma(structure_.constraints), c = VectorXd::Zero(n);
  model_.constraint_accelerations(at_.q.data(), at_.v.data(), gamma.data());
  if (!dependent_.empty()) c(dependent_) = -dense::solve(held_, gamma);
  model_.forces(at_.q.data(), at_.v.data(), force_.data());
  refuse_wrong_force(structure_, force_, at_.time);
  at_.a.head(n) = c;
  if (free == 0) return;
  MatrixXd r = MatrixXd::Zero(n, free);
  r(independent_, Eigen::all) = MatrixXd::Identity(free, free);
  if (!dependent_.empty())
    r(dependent_, Eigen::all) = -dense::solve(held_, MatrixXd(jacobian_(Eigen::all, independent_)));
  const dense::Qr reduced(dense::reduced(mass_, r));
  if (reduced.rank() < free)
    refuse_singular(structure_, "reduced mass matrix",
                    independent_[reduced.colsPermutation().indices()[reduced.rank()]], at_.time);
  at_.a.head(n) = r * dense::solve(reduced, VectorXd(r.transpose() * (force_ - mass_ * c))) + c;
}

void NullSpace::solve_multipliers() {
  at_.lambda.setZero(structure_.constraints);
  if (structure_.constraints == 0) return;
  const VectorXd rest = force_ - mass_ * at_.a.head(structure_.variables);
  at_.lambda = dense::shortest_solution(jacobian_.transpose(), rest);
}

void NullSpace::accelerations(double t, const double* y, const double* v, double* a) {
  const int free = size();
  at_.time = t;
  at_.q(independent_) = Eigen::Map<const VectorXd>(y, free);
  at_.v(independent_) = Eigen::Map<const VectorXd>(v, free);
  model_.at_time(t);
  solve_positions();
  solve_velocities();
  solve_accelerations();
  Eigen::Map<VectorXd>(a, free) = at_.a(independent_);
}

bool NullSpace::begin(const State& s, Motion& motion) {
  at_ = s;
  model_.at_time(s.time);
  constraints();
  refuse_lost_constraint(model_, s, {phi_.data(), most_off_.data(), jacobian_values_.data()});
  const bool changed = choose();
  motion = {s.time, s.q(independent_), s.v(independent_), s.a(independent_)};
  return changed;
}

void NullSpace::finish(const Motion&, State& s) {
  refuse_lost_constraint(model_, at_, {phi_.data(), most_off_.data(), jacobian_values_.data()});
  solve_multipliers();
  s = at_;
}

void NullSpace::start(State& s) {
  chosen_ = false;
  refresh(s);
}

void NullSpace::refresh(State& s) {
  Motion motion;
  begin(s, motion);
  accelerations(s.time, motion.y.data(), motion.v.data(), motion.a.data());
  solve_multipliers();
  s.a = at_.a;
  s.lambda = at_.lambda;
}

}  // namespace tandem::mbs
