// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Light fast masses on springs beside a slow side.
#pragma once
#include <Eigen/Core>

#include "tandem/fixed_step.hpp"

namespace tandem::test {

using Eigen::VectorXd;

/// Masses m x'' = -ground x - F on springs and dampers, F = k (x - y) + c (x' - y'). With reactive inputs y' is one, too.
struct FastMasses {
  VectorXd mass, ground, x0, v0;
  double stiffness, damping, h;
  bool reacts = false;
  VectorXd x = {}, v = {}, y = {}, w = {}, z = {};
  const Reaction* reaction = nullptr;

  SubsystemInfo info() const {
    const int n = static_cast<int>(mass.size());
    SubsystemInfo all{
        "fast", {{"y", "m", n}}, {{"x", "m", n}, {"F", "N", n}}, {}, {.reactive_inputs = reacts}};
    if (reacts) all.inputs.push_back({"w", "m/s", n});
    for (int k = 0; k < n; ++k) all.feedthrough.push_back({n + k, k});
    return all;
  }
  void react(const Reaction* of) {
    reaction = of;
    z = of ? VectorXd(Eigen::Map<const VectorXd>(of->begin, of->states)) : VectorXd();
  }
  std::span<const double> reaction_states() const { return {z.data(), static_cast<std::size_t>(z.size())}; }
  double own_step() const { return h; }
  void start(double, std::span<const double> u0) {
    x = x0, v = v0, w = 0.0 * v0;
    y = Eigen::Map<const VectorXd>(u0.data(), x.size());
  }
  /// As one system with the states of the reaction.
  void step_with_reaction(const OwnStep& s, std::span<const Signal> in) {
    const Eigen::Index n = x.size();
    const auto rates = [&](const VectorXd& all, double t) {
      const VectorXd at = all.head(n), rate = all.segment(n, n);
      read_reacting(in, t, all.data() + 2 * n);
      VectorXd told(2 * n), change(all.size());
      told << at, force(at, rate, y, w);
      change.head(2 * n) << rate, acceleration(at, rate, told.tail(n));
      tandem_reaction_rates(reaction, t, all.data() + 2 * n, told.data(), change.data() + 2 * n);
      return change;
    };
    VectorXd all(2 * n + z.size());
    all << x, v, z;
    const double l = s.length, middle = s.begin + l / 2;
    const VectorXd a = rates(all, s.begin), b = rates(all + l / 2 * a, middle),
                   c = rates(all + l / 2 * b, middle), d = rates(all + l * c, s.end);
    all += l / 6 * (a + 2 * b + 2 * c + d);
    x = all.head(n), v = all.segment(n, n), z = all.tail(z.size());
    read_reacting(in, s.end, z.data());
  }
  void step(const OwnStep& s, std::span<const Signal> in) {
    if (reaction) return step_with_reaction(s, in);
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
  void read_reacting(std::span<const Signal> in, double t, const double* states) {
    const auto n = static_cast<std::size_t>(x.size());
    for (std::size_t k = 0; k < n; ++k)
      y[static_cast<Eigen::Index>(k)] = in[k].value(t, states),
      w[static_cast<Eigen::Index>(k)] = in[n + k].value(t, states);
  }
  void read(std::span<const Signal> in, double t) {
    for (Eigen::Index k = 0; k < x.size(); ++k) {
      const Signal& one = in[static_cast<std::size_t>(k)];
      y[k] = one.value(t), w[k] = one.derivative(t);
    }
  }
};

}  // namespace tandem::test
