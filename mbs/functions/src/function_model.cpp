// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/functions/function_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tandem/error.hpp"

namespace tandem::mbs {
namespace {

Pattern dense(int rows, int columns) {
  std::vector<std::pair<int, int>> entries;
  for (int j = 0; j < columns; ++j)
    for (int i = 0; i < rows; ++i) entries.emplace_back(i, j);
  return {rows, columns, std::move(entries)};
}

}  // namespace

FunctionModel::FunctionModel(std::unique_ptr<Functions> functions) : functions_(std::move(functions)) {
  const int n = info().size(), m = info().constraints;
  structure_.coordinates = structure_.variables = n;
  structure_.constraints = m;
  structure_.jacobian = dense(n, m);
  const bool derivatives = info().has(Term::stiffness) || info().has(Term::damping);
  structure_.stiffness = derivatives ? dense(n, n) : Pattern(n, n, {});
  structure_.symmetric_forces = !derivatives;
  structure_.variable_names = info().variables;
  for (int j = 0; j < m; ++j) structure_.constraint_names.push_back(fmt::format("constraint {}", j + 1));
  jacobian_.resize(static_cast<std::size_t>(n * m));
  take_mass();
}

void FunctionModel::take_mass() {
  const int n = info().size();
  structure_.mass = {dense(n, n), std::vector<double>(static_cast<std::size_t>(n * n))};
  evaluate(Term::mass, nullptr, nullptr, structure_.mass.values.data());
  const Eigen::Map<const Eigen::MatrixXd> mass(structure_.mass.values.data(), n, n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < j; ++i)
      if (mass(i, j) != mass(j, i))
        throw Error(
            ErrorCode::invalid_argument,
            fmt::format("model '{}': mass has {} at ({}, {}) and {} at ({}, {}); allowed is a symmetric "
                        "matrix",
                        info().name, mass(i, j), i + 1, j + 1, mass(j, i), j + 1, i + 1));
}

State FunctionModel::initial(double t) const {
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(info().size());
  return {t, info().q, info().v, none, Eigen::VectorXd::Zero(info().constraints)};
}

void FunctionModel::evaluate(Term term, const double* q, const double* v, double* values) const {
  const Shape s = shape(term, info());
  functions_->evaluate(term, time_, q, v, {values, static_cast<std::size_t>(s.size())});
  for (int k = 0; k < s.size(); ++k)
    if (!std::isfinite(values[k]))
      throw Error(ErrorCode::numerical,
                  fmt::format("model '{}': {} at t = {} s is {} at ({}, {}); allowed is a finite number",
                              info().name, name(term), time_, values[k], k % s.rows + 1, k / s.rows + 1));
}

void FunctionModel::constraints(const double* q, double* phi, double* jacobian) const {
  evaluate(Term::constraints, q, nullptr, phi);
  evaluate(Term::jacobian, q, nullptr, jacobian_.data());
  const int n = info().size(), m = info().constraints;
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Eigen::Map<RowMajor>(jacobian, m, n) = Eigen::Map<const Eigen::MatrixXd>(jacobian_.data(), m, n);
}

void FunctionModel::constraint_rates(const double* q, double* phi_t) const {
  if (info().has(Term::constraint_rates))
    evaluate(Term::constraint_rates, q, nullptr, phi_t);
  else
    std::fill_n(phi_t, info().constraints, 0.0);
}

void FunctionModel::constraint_accelerations(const double* q, const double* v, double* gamma) const {
  evaluate(Term::constraint_accelerations, q, v, gamma);
}

void FunctionModel::forces(const double* q, const double* v, double* force) const {
  evaluate(Term::forces, q, v, force);
}

void FunctionModel::force_derivatives(const double* q, const double* v, double* k, double* c) const {
  const auto take = [&](Term term, double* values) {
    if (info().has(term))
      evaluate(term, q, v, values);
    else
      std::fill_n(values, info().size() * info().size(), 0.0);
  };
  take(Term::stiffness, k);
  take(Term::damping, c);
}

double FunctionModel::energy(const double* q, const double* v) const {
  double energy = std::numeric_limits<double>::quiet_NaN();
  if (info().has(Term::energy)) evaluate(Term::energy, q, v, &energy);
  return energy;
}

}  // namespace tandem::mbs
