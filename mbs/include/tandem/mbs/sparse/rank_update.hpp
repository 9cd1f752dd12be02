// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "tandem/mbs/sparse/pattern.hpp"

namespace tandem::mbs {

/// base + factor A A^T at given entries, A in compressed columns (Phi_q^T alpha Phi_q: A = Phi_q^T). This
/// symmetric rank-k update is prepared as a list of where the products of each column with itself go (F.
/// Gonzalez, doctoral thesis, A Coruna 2010, chapter 3). The rows of a point go together where they stand
/// together. The columns of an A of 4000 or more are coloured: columns of one colour have no row in common,
/// so threads can share them, and sums are the same with any number of threads. The columns of a smaller A
/// are not shared.
class RankUpdate {
 public:
  /// layout: by position of the result the (row, column) it holds; (-1, -1) for none. Precondition: it has
  /// all entries of A A^T, in either triangle or in both, which get the same bits.
  RankUpdate(const Pattern& a, std::span<const std::pair<int, int>> layout);
  /// result[e] = base[e] + factor (A A^T)[e]. They may be the same array if the layout names no entry twice.
  void run(const double* a, double factor, const double* base, double* result) const;

 private:
  /// Columns of A of one colour with equally many blocks of equally many rows, so that the loop within needs
  /// no condition.
  struct Group {
    int blocks, together;
    std::vector<std::int32_t> starts;   ///< by column: its first position in A
    std::vector<std::int32_t> targets;  ///< where its products go, in the order of add_products()
  };
  std::vector<Group> groups_;
  /// (from, to): entries that the layout names again
  std::vector<std::pair<std::int32_t, std::int32_t>> copies_;
  std::size_t size_;  ///< of the result
  bool coloured_, both_;
};

}  // namespace tandem::mbs
