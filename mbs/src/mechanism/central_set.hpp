// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>

#include "force_set.hpp"

namespace tandem::mbs {

/// Springs, dampers and actuators between two points: with l their distance and e the direction from a to b,
/// a is pulled by F e and b by -F e, F = law(l, l') - gain u(t). The stiffness is symmetric:
///   K = F_l e e^T + F / l (1 - e e^T), C = F_l' e e^T;
/// what the turning of a damper's rate l' = e . (b' - a') adds to K is left out (it makes it unsymmetric, and
/// Newton's iteration converges without it).
template <int Dimension>
class CentralSet final : public ForceSet {
 public:
  struct Central {
    int a, b;  ///< first coordinates of the points
    SpringLaw law;
    int input;  ///< -1: none
    double gain;
  };
  explicit CentralSet(const std::vector<InputValue>& inputs) : inputs_(inputs) {}
  void add(const Central& central) { all_.push_back(central); }
  bool empty() const { return all_.empty(); }

  void add(const double* q, const double* v, double* force) const override {
    for (const Central& c : all_) {
      const Way way(c, q, v);
      const Vector f = pull(c, way).force * way.direction;
      for (int d = 0; d < Dimension; ++d) force[c.a + d] += f[d], force[c.b + d] -= f[d];
    }
  }

  std::vector<std::pair<int, int>> entries() const override {
    std::vector<std::pair<int, int>> list;
    for (const Central& c : all_)
      for (int column = 0; column < Dimension; ++column)
        for (int row = 0; row < Dimension; ++row)
          for (const auto& [r, s] : {std::pair(c.a, c.a), {c.b, c.b}, {c.a, c.b}, {c.b, c.a}})
            list.emplace_back(r + row, s + column);
    return list;
  }

  void add_derivatives(const double* q, const double* v, double* k, double* c) const override {
    const int* to = to_.data();
    for (const Central& central : all_) {
      const Way way(central, q, v);
      const auto law = pull(central, way);
      const Block along = way.direction * way.direction.transpose();
      const Block stiffness = law.by_x * along + law.force / way.length * (Block::Identity() - along);
      const Block damping = law.by_v * along;
      for (int e = 0; e < Dimension * Dimension; ++e, to += 4)
        for (int corner = 0; corner < 4; ++corner) {
          const double sign = corner < 2 ? 1.0 : -1.0;
          k[to[corner]] += sign * stiffness(e), c[to[corner]] += sign * damping(e);
        }
    }
  }

  double potential(const double* q) const override {
    double sum = 0.0;
    for (const Central& c : all_) sum += c.law.potential(Way(c, q, q).length);
    return sum;
  }

 private:
  using Vector = Eigen::Matrix<double, Dimension, 1>;
  using Block = Eigen::Matrix<double, Dimension, Dimension>;
  struct Way {
    double length, rate;
    Vector direction;
    Way(const Central& c, const double* q, const double* v) {
      const Eigen::Map<const Vector> a(q + c.a), b(q + c.b), av(v + c.a), bv(v + c.b);
      length = (b - a).norm();
      direction = (b - a) / length;
      rate = direction.dot(bv - av);
    }
  };
  SpringLaw::Pull pull(const Central& c, const Way& way) const {
    auto pull = c.law.at(way.length, way.rate);
    if (c.input >= 0) pull.force -= c.gain * inputs_[static_cast<std::size_t>(c.input)].value;
    return pull;
  }

  const std::vector<InputValue>& inputs_;
  std::vector<Central> all_;
};

}  // namespace tandem::mbs
