// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "constraint_set.hpp"

namespace tandem::mbs {

/// Constant scalar products of two edges: (a1 - a0) . (b1 - b0) - value = 0, each the first coordinate of a
/// point or vector (a0 of a vector: the first of coordinates that are zero).
template <int Dimension>
class ProductSet final : public ConstraintSet {
 public:
  struct Product {
    int a1, a0, b1, b0;
    double value;
  };
  void add(const Product& product) { products_.push_back(product); }

  int size() const override { return static_cast<int>(products_.size()); }
  std::vector<int> coordinates(int equation) const override {
    const Product& p = products_[equation];
    std::vector<int> list;
    for (const int first : {p.a1, p.a0, p.b1, p.b0})
      for (int d = 0; d < Dimension; ++d) list.push_back(first + d);
    return list;
  }

  /// A coordinate may belong to both edges, so entries add up.
  void values(const double* q, double* phi, double* jacobian) const override {
    for (const int to : to_) jacobian[to] = 0.0;
    const int* to = to_.data();
    phi += first_;
    for (const Product& p : products_) {
      double product = 0.0;
      for (int d = 0; d < Dimension; ++d, ++to) {
        const double a = q[p.a1 + d] - q[p.a0 + d], b = q[p.b1 + d] - q[p.b0 + d];
        product += a * b;
        jacobian[to[0]] += b;
        jacobian[to[Dimension]] -= b;
        jacobian[to[2 * Dimension]] += a;
        jacobian[to[3 * Dimension]] -= a;
      }
      to += 3 * Dimension;
      *phi++ = product - p.value;
    }
  }

  void accelerations(const double*, const double* v, double* gamma) const override {
    gamma += first_;
    for (const Product& p : products_) {
      double product = 0.0;
      for (int d = 0; d < Dimension; ++d)
        product += (v[p.a1 + d] - v[p.a0 + d]) * (v[p.b1 + d] - v[p.b0 + d]);
      *gamma++ = 2.0 * product;
    }
  }

 private:
  std::vector<Product> products_;
};

}  // namespace tandem::mbs
