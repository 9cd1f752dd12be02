// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>

#include "small_count.hpp"

namespace tandem::mbs {

template <int rows>
using Block = Eigen::Matrix<double, rows, 1>;

/// Adds blocks of rows to a result, each where the next target says. Inlined whatever the size of the unit: a
/// sum in memory takes twice the time.
struct BlockSum {
  double* result;
  const std::int32_t* target;
  template <int rows>
  [[gnu::always_inline]] void add(const Block<rows>& block) {
    Eigen::Map<Block<rows>>{result + * target++} += block;
  }
};

/// Of a block of one or two with itself, column by column: all rows, or those from the diagonal on. Of each
/// pair of entries the later one is scaled, here and below, so that both triangles get the same bits.
template <bool both, int together>
[[gnu::always_inline]] inline void add_square(const Block<together>& a, const Block<together>& scaled,
                                              BlockSum& sum) {
  sum.add<together>(scaled * a[0]);
  if constexpr (together == 2 && both) sum.add<2>(a * scaled[1]);
  if constexpr (together == 2 && !both) sum.add<1>(Block<1>(scaled[1] * a[1]));
}

/// sum += factor (a a^T) for columns `a` of so many blocks, each of which starts somewhere in `values`: of
/// block q with itself, then of those behind it with q and, where both triangles are wanted, of q with them.
template <bool both, int together, class Blocks>
void add_products(Blocks count, std::span<const std::int32_t> starts, const double* values, double factor,
                  BlockSum sum) {
  const int blocks = count;
  for (const std::int32_t start : starts) {
    const double* a = values + start;
    std::array<double, 6 * together> local;
    if constexpr (!std::is_integral_v<Blocks>) {  // or they would be read again after each store
      for (int k = 0; k < blocks * together; ++k) local[k] = a[k];
      a = local.data();
    }
    const auto block = [&](int p) -> Block<together> { return Block<together>::Map(a + p * together); };
#pragma GCC unroll 6
    for (int q = 0; q < blocks; ++q) {
      const Block<together> first = block(q), first_scaled = factor * first;
      add_square<both>(first, first_scaled, sum);
#pragma GCC unroll 6
      for (int p = q + 1; p < blocks; ++p) {
        const Block<together> scaled = factor * block(p);
        for (int d = 0; d < together; ++d) sum.add<together>(scaled * first[d]);
        if constexpr (both)
          for (int d = 0; d < together; ++d) sum.add<together>(first * scaled[d]);
      }
    }
  }
}

}  // namespace tandem::mbs
