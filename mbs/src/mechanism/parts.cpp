// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "parts.hpp"

#include "groups.hpp"

namespace tandem::mbs {
namespace {

/// Rows with columns, which are numbers from `first` on.
void join(Groups& groups, const Pattern& a, int first) {
  for (const auto& [row, column] : a.entries()) groups.join(row, first + column);
}

/// Of both ends.
std::vector<int> coordinates_of(const Mechanism& m, const Edge& edge) {
  std::vector<int> all;
  for (const int point : {edge.from, edge.to})
    for (int k = 0; k < m.description().dimension; ++k) all.push_back(m.coordinate(point) + k);
  return all;
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

std::vector<std::vector<int>> force_groups(const Mechanism& m) {
  const Description& in = m.description();
  std::vector<std::vector<int>> groups;
  for (const Spring& spring : in.springs)
    if (spring.relative < 0) groups.push_back(coordinates_of(m, spring.points));
  for (const Force& force : in.forces)
    if (force.kind == Force::Kind::line) groups.push_back(places(m, force));
  for (const NamedElement& element : in.elements) {
    groups.emplace_back();
    for (const Coordinate& c : element.force->coordinates()) groups.back().push_back(m.numbering().of(c));
  }
  return groups;
}

std::vector<int> places(const Mechanism& m, const Force& force) {
  std::vector<int> along;
  switch (force.kind) {
    case Force::Kind::relative:
      return {m.numbering().relative[static_cast<std::size_t>(force.index)]};
    case Force::Kind::point:
      for (int k = 0; k < m.description().dimension; ++k)
        if (force.direction[k] != 0.0) along.push_back(m.coordinate(force.index) + k);
      return along;
    default:
      return coordinates_of(m, force.points);
  }
}

}  // namespace tandem::mbs
