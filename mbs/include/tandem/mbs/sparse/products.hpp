// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "tandem/mbs/sparse/pattern.hpp"

namespace tandem::mbs {

/// y = A x for a symmetric A that stores both triangles: of each column a dot product.
void multiply_symmetric(const Matrix& a, const double* x, double* y);

/// y = A^T x: of each column of A a dot product. With A = Phi_q^T this is Phi_q x.
void multiply_transposed(const Pattern& a, const double* values, const double* x, double* y);

/// y += A x: of each column a multiple. With A = Phi_q^T, constraint forces of multipliers.
void add_product(const Pattern& a, const double* values, const double* x, double* y);

/// base + factor A A^T at given entries, A in compressed columns (Phi_q^T alpha Phi_q: A = Phi_q^T): a
/// symmetric rank-k update, prepared as a list of products for each entry (F. Gonzalez, doctoral thesis,
/// A Coruna 2010, chapter 3).
class RankUpdate {
 public:
  /// target: by position of the result the (row, column) it holds; (-1, -1) for none.
  RankUpdate(const Pattern& a, std::span<const std::pair<int, int>> target);
  /// result[e] = base[e] + factor (A A^T)[e]. They may be the same array.
  void run(const double* a, double factor, const double* base, double* result) const;

 private:
  struct Factors {
    std::int32_t left, right;  ///< positions in A
  };
  /// Entries with equally many products, so that nothing is asked within.
  struct Group {
    std::size_t products, entries;
  };
  std::vector<Group> groups_;
  std::vector<std::int32_t> targets_;  ///< by entry
  std::vector<Factors> factors_;       ///< `products` for each entry
  std::size_t size_;                   ///< of the result
};

}  // namespace tandem::mbs
