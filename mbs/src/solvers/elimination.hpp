// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "tandem/mbs/sparse/pattern.hpp"

namespace tandem::mbs::solvers {

/// Columns next to each other that have the same rows below their last: a dense block in L.
struct Supernode {
  int first, columns;     ///< places
  std::vector<int> rows;  ///< places below the block, ascending
};

/// What Cholesky's elimination of a symmetric pattern leads to (A. George, J. Liu, Computer Solution of Large
/// Sparse Positive Definite Systems, 1981, ch. 5; supernodes: J. Liu, E. Ng, B. Peyton, SIAM J. Matrix Anal.
/// Appl. 14 (1993) 242).
struct Elimination {
  std::vector<int> order;  ///< by place the column
  std::vector<Supernode> supernodes;
};

/// In a given order, rearranged (to one with the same fill) such that supernodes stand together. A supernode
/// with more than `most` columns is cut.
Elimination eliminate(const Pattern& pattern, const std::vector<int>& order, int most);

/// Multiplications that a factorization takes.
double operations(const Elimination& elimination);

}  // namespace tandem::mbs::solvers
