// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <bit>
#include <cstddef>
#include <limits>
#include <vector>

namespace tandem {

/// The least of many numbers that change one at a time: a tree of which each node is the lesser of the two
/// below it.
class Earliest {
 public:
  explicit Earliest(std::size_t count = 1)
      : leaves_(std::bit_ceil(count)), tree_(2 * leaves_, std::numeric_limits<double>::max()) {}

  double value() const { return tree_[1]; }
  void set(std::size_t k, double value) {
    std::size_t node = leaves_ + k;
    tree_[node] = value;
    while (node > 1) {
      node /= 2;
      const double least = std::min(tree_[2 * node], tree_[2 * node + 1]);
      if (tree_[node] == least) return;
      tree_[node] = least;
    }
  }

 private:
  std::size_t leaves_;
  std::vector<double> tree_;  ///< the root is number 1
};

}  // namespace tandem
