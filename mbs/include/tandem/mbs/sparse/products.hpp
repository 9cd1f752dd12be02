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

/// result = a + factor b, values on one pattern (the union of both: unite(), positions()): one vector
/// operation. result may be a.
void add_scaled(std::size_t size, const double* a, double factor, const double* b, double* result);

/// base + factor A A^T at given entries, A in compressed columns (Phi_q^T alpha Phi_q: A = Phi_q^T): a
/// symmetric rank-k update, prepared as a list of where the products of each column with itself go
/// (F. Gonzalez, doctoral thesis, A Coruna 2010, chapter 3).
class RankUpdate {
 public:
  /// target: by position of the result the (row, column) it holds; (-1, -1) for none. Precondition: it has
  /// all entries of A A^T, in either triangle or in both.
  RankUpdate(const Pattern& a, std::span<const std::pair<int, int>> target);
  /// result[e] = base[e] + factor (A A^T)[e]. They may be the same array if the target names no entry twice.
  void run(const double* a, double factor, const double* base, double* result) const;

 private:
  /// Columns of A with equally many entries, so that nothing is asked within.
  struct Group {
    std::size_t entries, columns;
  };
  struct Copy {
    std::int32_t from, to;  ///< an entry that the target names again
  };
  std::vector<Group> groups_;
  std::vector<std::int32_t> starts_;   ///< by column, in order of the groups: its first position in A
  std::vector<std::int32_t> targets_;  ///< of its products, those of each entry with itself and those before
  std::vector<Copy> copies_;
  std::size_t size_;  ///< of the result
};

}  // namespace tandem::mbs
