// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <vector>

#include "tandem/mbs/sparse/pattern.hpp"

namespace tandem::mbs {

/// y = A x for a symmetric A that stores both triangles: of each column a dot product.
void multiply_symmetric(const Matrix& a, const double* x, double* y);

/// y = A^T x: of each column of A a dot product. With A = Phi_q^T this is Phi_q x.
void multiply_transposed(const Pattern& a, const double* values, const double* x, double* y);

/// The rows of a matrix that is stored by columns, so that y = A x is a dot product of each row, too: nothing
/// is written twice, and threads can share the rows. With A = Phi_q^T, constraint forces of multipliers. Two
/// or three rows with entries in the same columns, as those of a point, are multiplied together.
class Rows {
 public:
  explicit Rows(const Pattern& a);
  /// y = A x.
  void multiply(const double* values, const double* x, double* y) const;

 private:
  struct Entry {
    int position, column;  ///< the first: in the first row of its block
  };
  void add(const Pattern& a, int row, const std::vector<int>& columns, int together);
  void multiply(const double* values, const double* x, double* y, int first, int last) const;
  std::vector<Pattern::Run> runs_;  ///< of rows here, not of columns; start: the first entry
  std::vector<Entry> entries_;      ///< of the first row of each block
  int rows_;
};

/// The least and the greatest sum of squares of a column; infinity and 0 if there is no column.
struct ColumnSquares {
  double least, most;
};
ColumnSquares column_squares(const Pattern& a, const double* values);

/// result = a + factor b, values on one pattern (the union of both: unite(), positions()): one vector
/// operation. result may be a.
void add_scaled(std::size_t size, const double* a, double factor, const double* b, double* result);

}  // namespace tandem::mbs
