// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A slow side of any equations (the cases of docs/impulse_coupling.md).
#pragma once
#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <functional>
#include <numbers>

#include "tandem/fixed_step.hpp"

namespace tandem::test {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// M(q) q'' = f(q, q') + J^T F with displacements y(q) and J = dy/dq.
struct SlowEquations {
  std::function<MatrixXd(const VectorXd& q)> mass;
  std::function<VectorXd(const VectorXd& q, const VectorXd& u)> force;
  std::function<VectorXd(const VectorXd& q)> displacement;
  std::function<MatrixXd(const VectorXd& q)> jacobian;
  VectorXd q, u;             ///< at the start
  double rate_factor = 1.0;  ///< of what it tells of its accelerance; 1 is right

  /// pushed: forces on the links, then generalised ones on the coordinates or nothing.
  VectorXd acceleration(const VectorXd& at, const VectorXd& rate, const VectorXd& pushed) const {
    const MatrixXd j = jacobian(at);
    VectorXd push = j.transpose() * pushed.head(j.rows());
    if (pushed.size() > j.rows()) push += pushed.tail(at.size());
    return mass(at).llt().solve(force(at, rate) + push);
  }
  MatrixXd accelerance(const VectorXd& at) const {
    const MatrixXd j = jacobian(at);
    return j * mass(at).llt().solve(j.transpose());
  }
};

/// It by the trapezoidal rule. Outputs: displacements y, the matrix A by rows, and coordinates q. Inputs: forces F on the links,
/// and generalised ones on all coordinates.
struct SlowSide {
  SlowEquations m;
  double h;
  bool whole = false;                    ///< takes forces on its coordinates
  VectorXd q = {}, u = {}, pushed = {};  ///< pushed: on the links, then on the coordinates

  int links() const { return static_cast<int>(m.displacement(m.q).size()); }
  int coordinates() const { return static_cast<int>(m.q.size()); }
  SubsystemInfo info() const {
    SubsystemInfo all{
        "slow",
        {{"F", "N", links()}},
        {{"y", "m", links(), 2}, {"A", "1/kg", links() * links(), 1}, {"q", "", coordinates(), 2}},
        {},
        {}};
    if (whole) all.inputs.push_back({"reaction", "", coordinates()});
    for (int i = 0; i < links(); ++i)
      for (int k = 0; k < links(); ++k) all.feedthrough.push_back({i, k});
    return all;
  }
  double own_step() const { return h; }
  void start(double, std::span<const double> u0) {
    q = m.q, u = m.u;
    pushed = Eigen::Map<const VectorXd>(u0.data(), static_cast<Eigen::Index>(u0.size()));
    pushed = pushed.unaryExpr([](double one) { return std::isnan(one) ? 0.0 : one; });
  }
  void step(const OwnStep& s, std::span<const Signal> in) {
    for (Eigen::Index k = 0; k < pushed.size(); ++k)
      pushed[k] = in[static_cast<std::size_t>(k)].value(s.begin + 0.5 * s.length);
    const double l = s.length;
    const VectorXd a = m.acceleration(q, u, pushed);
    const auto rate_at = [&](const VectorXd& at) { return VectorXd(2.0 / l * (at - q) - u); };
    const auto off = [&](const VectorXd& at) {
      return VectorXd(rate_at(at) - u - 0.5 * l * (a + m.acceleration(at, rate_at(at), pushed)));
    };
    VectorXd next = q + l * u, rate;
    MatrixXd gradient(q.size(), q.size());
    for (Eigen::Index k = 0; k < q.size(); ++k) {
      VectorXd step = VectorXd::Zero(q.size());
      step[k] = 1e-5;
      gradient.col(k) = (off(next + step) - off(next - step)) / 2e-5;
    }
    const Eigen::PartialPivLU<MatrixXd> solver(gradient);
    for (int k = 0; k < 50; ++k) {
      const VectorXd by = solver.solve(off(next));
      next -= by;
      if (by.norm() < 1e-15 * next.norm()) break;
    }
    rate = rate_at(next);
    q = next, u = rate;
  }
  /// Rates along the motion by central differences.
  void outputs(double* y) const {
    const double by = 1e-5 / (1.0 + u.norm());
    const MatrixXd j = m.jacobian(q), turned = (m.jacobian(q + by * u) - m.jacobian(q - by * u)) / (2.0 * by);
    const MatrixXd a = m.accelerance(q),
                   rate =
                       m.rate_factor * (m.accelerance(q + by * u) - m.accelerance(q - by * u)) / (2.0 * by);
    const auto put = [&y](const auto& numbers) {
      for (Eigen::Index k = 0; k < numbers.size(); ++k) *y++ = numbers(k);
    };
    const VectorXd faster = m.acceleration(q, u, pushed);
    put(m.displacement(q)), put(a), put(q), put(VectorXd(j * u)), put(rate), put(u);
    put(VectorXd(j * faster + turned * u)), put(MatrixXd(0.0 * rate)), put(faster);
  }
};

}  // namespace tandem::test
