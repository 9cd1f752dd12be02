// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <cstddef>

#include "constraint_set.hpp"
#include "team.hpp"

namespace tandem::mbs {

/// Constant distances: (|b - a|^2 - l^2) / l = 0, a and b the first coordinates of two points. Divided by l,
/// gradients have length 2 whatever the size of a mechanism, so that one penalty serves all.
template <int Dimension>
class DistanceSet final : public ConstraintSet {
 public:
  void add(int a, int b, double square) { pairs_.push_back({a, b, square, 1.0 / std::sqrt(square)}); }

  int size() const override { return static_cast<int>(pairs_.size()); }
  std::vector<int> coordinates(int equation) const override {
    std::vector<int> list;
    for (const int point : {pairs_[equation].a, pairs_[equation].b})
      for (int d = 0; d < Dimension; ++d) list.push_back(point + d);
    return list;
  }

  void values(const double* q, double* phi, double* jacobian) const override {
    share(size(), [=, this](int first, int last) {
      const int* to = to_.data() + 2 * Dimension * first;
      for (int k = first; k < last; ++k, to += 2 * Dimension) {
        const Pair& p = pairs_[k];
        double square = 0.0;
        for (int d = 0; d < Dimension; ++d) {
          const double along = q[p.b + d] - q[p.a + d];
          square += along * along;
          jacobian[to[d]] = -2.0 * p.scale * along;
          jacobian[to[Dimension + d]] = 2.0 * p.scale * along;
        }
        phi[first_ + k] = p.scale * (square - p.square);
      }
    });
  }

  void accelerations(const double*, const double* v, double* gamma) const override {
    share(size(), [=, this](int first, int last) {
      for (int k = first; k < last; ++k) {
        const Pair& p = pairs_[k];
        double square = 0.0;
        for (int d = 0; d < Dimension; ++d) {
          const double along = v[p.b + d] - v[p.a + d];
          square += along * along;
        }
        gamma[first_ + k] = 2.0 * p.scale * square;
      }
    });
  }

 private:
  struct Pair {
    int a, b;
    double square, scale;
  };
  std::vector<Pair> pairs_;
};

}  // namespace tandem::mbs
