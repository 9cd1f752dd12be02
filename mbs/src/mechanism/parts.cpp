// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "parts.hpp"

#include "groups.hpp"

namespace tandem::mbs {
namespace {

/// Rows with columns, which are numbers from `first` on.
void join(Groups& groups, const Pattern& a, int first) {
  for (const auto& [row, column] : a.entries()) groups.join(row, first + column);
}

}  // namespace

std::vector<int> connected_parts(const Mechanism& m) {
  const Structure& s = m.structure();
  Groups parts(s.coordinates + s.constraints);
  join(parts, s.mass.pattern, 0);
  join(parts, s.jacobian, s.coordinates);
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
