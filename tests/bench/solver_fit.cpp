// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "bench/solver_fit.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <cmath>
#include <vector>

namespace tandem::bench {
namespace {

Eigen::RowVector4d terms(const std::string& solver, const mbs::EliminationCost& cost) {
  const double n = cost.columns, w = cost.band_width;
  if (solver == "band" || solver == "lapack_band") return {1.0, n, n * w, n * w * w};
  if (solver == "lapack" || solver == "lapack_lu" || solver == "eigen_dense")
    return {1.0, n, n * n, n * n * n};
  return {1.0, n, cost.entries, cost.operations};
}

/// The x >= 0 with the least |A x - b|: that of the subset of columns on which the plain solution has no
/// negative entry, and the smallest residual.
Eigen::Vector4d not_negative(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  Eigen::Vector4d best = Eigen::Vector4d::Zero();
  for (unsigned subset = 1; subset < 16; ++subset) {
    std::vector<Eigen::Index> columns;
    for (Eigen::Index c = 0; c < 4; ++c)
      if (subset >> c & 1U) columns.push_back(c);
    Eigen::Vector4d x = Eigen::Vector4d::Zero();
    x(columns) = a(Eigen::all, columns).colPivHouseholderQr().solve(b);
    if (x.minCoeff() >= 0.0 && (a * x - b).norm() < (a * best - b).norm()) best = x;
  }
  return best;
}

}  // namespace

void SolverFit::print() const {
  fmt::print("{:<18} {:<20} {:>10} {:>10} {:>10} {:>10} {:>6}\n", "kind", "solver", "start", "row", "entry",
             "operation", "rms");
  for (const auto& [name, times] : times_) {
    const auto rows = static_cast<Eigen::Index>(times.size());
    Eigen::MatrixXd a(rows, 4);
    for (Eigen::Index k = 0; k < rows; ++k)
      a.row(k) = terms(name.second, times[k].cost) / (1e9 * times[k].seconds);
    const Eigen::VectorXd one = Eigen::VectorXd::Ones(rows);
    const Eigen::Vector4d fitted = not_negative(a, one);
    fmt::print("{:<18} {:<20} {:>10.4g} {:>10.4g} {:>10.4g} {:>10.4g} {:>6.2f}\n", name.first, name.second,
               fitted[0], fitted[1], fitted[2], fitted[3],
               (a * fitted - one).norm() / std::sqrt(static_cast<double>(rows)));
  }
}

}  // namespace tandem::bench
