// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Light fast masses on springs beside a slow side.
#pragma once
#include <Eigen/Core>

#include "tandem/fixed_step.hpp"

namespace tandem::test {

using Eigen::VectorXd;

/// Masses m x'' = -ground x - F on springs and dampers, F = k (x - y) + c (x' - y').
struct FastMasses {
  VectorXd mass, ground, x0, v0;
  double stiffness, damping, h;
  VectorXd x = {}, v = {}, y = {}, w = {};

  SubsystemInfo info() const {
    const int n = static_cast<int>(mass.size());
    SubsystemInfo all{"fast", {{"y", "m", n}}, {{"x", "m", n}, {"F", "N", n}}, {}, {}};
    for (int k = 0; k < n; ++k) all.feedthrough.push_back({n + k, k});
    return all;
  }
  double own_step() const { return h; }
  void start(double, std::span<const double> u0) {
    x = x0, v = v0, w = 0.0 * v0;
    y = Eigen::Map<const VectorXd>(u0.data(), x.size());
  }
  void step(const OwnStep& s, std::span<const Signal> in) {
    const auto a = [&](const VectorXd& at, const VectorXd& rate, double t) {
      read(in, t);
      return acceleration(at, rate, force(at, rate, y, w));
    };
    const double l = s.length, t = s.begin;
    const VectorXd a1 = a(x, v, t), v2 = v + l / 2 * a1, a2 = a(x + l / 2 * v, v2, t + l / 2);
    const VectorXd v3 = v + l / 2 * a2, a3 = a(x + l / 2 * v2, v3, t + l / 2), v4 = v + l * a3;
    const VectorXd a4 = a(x + l * v3, v4, s.end);
    x += l / 6 * (v + 2 * v2 + 2 * v3 + v4), v += l / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    read(in, s.end);
  }
  void outputs(double* to) const {
    Eigen::Map<VectorXd>(to, x.size()) = x, Eigen::Map<VectorXd>(to + x.size(), x.size()) = force(x, v, y, w);
  }
  VectorXd force(const VectorXd& at, const VectorXd& rate, const VectorXd& other,
                 const VectorXd& other_rate) const {
    return stiffness * (at - other) + damping * (rate - other_rate);
  }
  VectorXd acceleration(const VectorXd& at, const VectorXd&, const VectorXd& pull) const {
    return (-ground.cwiseProduct(at) - pull).cwiseQuotient(mass);
  }

 private:
  void read(std::span<const Signal> in, double t) {
    for (Eigen::Index k = 0; k < x.size(); ++k) {
      const Signal& one = in[static_cast<std::size_t>(k)];
      y[k] = one.value(t), w[k] = one.derivative(t);
    }
  }
};

}  // namespace tandem::test
