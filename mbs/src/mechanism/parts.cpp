// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "parts.hpp"

#include <numeric>

namespace tandem::mbs {
namespace {

/// Numbers that join.
class Parts {
 public:
  explicit Parts(int size) : parent_(static_cast<std::size_t>(size)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int find(int e) {
    while (parent_[e] != e) e = parent_[e] = parent_[parent_[e]];
    return e;
  }
  void join(int a, int b) { parent_[find(a)] = find(b); }
  /// Rows with columns, which are numbers from `first` on.
  void join(const Pattern& a, int first) {
    for (const auto& [row, column] : a.entries()) join(row, first + column);
  }

 private:
  std::vector<int> parent_;
};

}  // namespace

std::vector<int> connected_parts(const Mechanism& m) {
  const Structure& s = m.structure();
  Parts parts(s.coordinates + s.constraints);
  parts.join(s.mass.pattern, 0);
  parts.join(s.jacobian, s.coordinates);
  std::vector<int> all;
  for (int i = 0; i < s.coordinates + s.constraints; ++i) all.push_back(parts.find(i));
  return all;
}

std::vector<int> places(const Mechanism& m, const Force& force) {
  switch (force.kind) {
    case Force::Kind::relative:
      return {m.numbering().relative[static_cast<std::size_t>(force.index)]};
    case Force::Kind::point:
      return {m.coordinate(force.index)};
    default:
      return {m.coordinate(force.points.from), m.coordinate(force.points.to)};
  }
}

}  // namespace tandem::mbs
