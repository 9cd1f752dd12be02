// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <cmath>

#include "constraint_set.hpp"
#include "off.hpp"
#include "team.hpp"

namespace tandem::mbs {

/// Constant distances: (|b - a|^2 - l^2) / l = 0, a and b the first coordinates of two points. Divided by l,
/// gradients have length 2 whatever the size of a mechanism, so that one penalty serves all.
template <int Dimension>
class DistanceSet final : public ConstraintSet {
 public:
  void add(int a, int b, double square) {
    const double scale = 1.0 / std::sqrt(square);
    pairs_.push_back({a, b, square, scale, 2.0 * scale});
  }

  int size() const override { return static_cast<int>(pairs_.size()); }
  std::vector<int> coordinates(int equation) const override {
    std::vector<int> list;
    for (const int point : {pairs_[equation].a, pairs_[equation].b})
      for (int d = 0; d < Dimension; ++d) list.push_back(point + d);
    return list;
  }

  /// The entries of a point stand one behind the other, as its coordinates do.
  void values(const double* q, double* phi, double* jacobian) const override {
    share(size(), [=, pairs = pairs_.data(), to = to_.data(), phi = phi + first_](int first, int last) {
      const int* at = to + 2 * Dimension * first;
      for (int k = first; k < last; ++k, at += 2 * Dimension) {
        const Pair& p = pairs[k];
        const Vector along = way(p, q), gradient = p.twice_scale * along;
        Eigen::Map<Vector>(jacobian + at[0]) = -gradient;
        Eigen::Map<Vector>(jacobian + at[Dimension]) = gradient;
        phi[k] = p.scale * (square(along) - p.square);
      }
    });
  }

  void accelerations(const double*, const double* v, double* gamma) const override {
    share(size(), [=, pairs = pairs_.data(), gamma = gamma + first_](int first, int last) {
      for (int k = first; k < last; ++k) gamma[k] = pairs[k].twice_scale * square(way(pairs[k], v));
    });
  }

  Off off(int equation, const double*, double phi) const override {
    return off_of_distance(std::sqrt(pairs_[equation].square), phi);
  }

 private:
  using Vector = Eigen::Matrix<double, Dimension, 1>;
  struct Pair {
    int a, b;
    double square, scale, twice_scale;
  };
  static Vector way(const Pair& p, const double* x) {
    return Eigen::Map<const Vector>(x + p.b) - Eigen::Map<const Vector>(x + p.a);
  }
  /// In this order in the plane and in space.
  static double square(const Vector& x) {
    double sum = x[0] * x[0];
    for (int d = 1; d < Dimension; ++d) sum += x[d] * x[d];
    return sum;
  }

  std::vector<Pair> pairs_;
};

}  // namespace tandem::mbs
