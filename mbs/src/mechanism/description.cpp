// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/description.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace tandem::mbs {

Eigen::Vector3d drawn(const Description& in, const Edge& edge) {
  const Eigen::Vector3d to = in.entities[edge.to].at;
  return edge.from < 0 ? to : Eigen::Vector3d(to - in.entities[edge.from].at);
}

double drawn(const Ends& ends) { return (ends.places[1] - ends.places[0]).norm(); }

double drawn(const Description& in, const Relative& relative) {
  using enum Relative::Kind;
  if (relative.kind == free || relative.kind == state) return relative.at;
  if (relative.kind == length && relative.a.to < 0) return drawn(relative.ends);
  const Eigen::Vector3d a = drawn(in, relative.a);
  if (relative.kind == Relative::Kind::length) return a.norm();
  const Eigen::Vector3d b = drawn(in, relative.b),
                        n = in.dimension == 2 ? Eigen::Vector3d(Eigen::Vector3d::UnitZ())
                                              : Eigen::Vector3d(in.entities[relative.axis].at.normalized());
  return std::atan2(n.dot(a.cross(b)), a.dot(b) - n.dot(a) * n.dot(b));
}

bool is_angle(const Description& in, const Coordinate& c) {
  if (c.relative < 0) return false;
  const Relative& relative = in.relatives[static_cast<std::size_t>(c.relative)];
  return relative.kind == Relative::Kind::angle || relative.turns;
}

bool only_forces_follow(const Description& in, int input) {
  const auto acts = [input](const auto& one) { return one.input == input; };
  const auto moves = [input](const NamedElement& e) {
    const auto& inputs = e.force->inputs();
    return std::find(inputs.begin(), inputs.end(), input) != inputs.end();
  };
  return std::any_of(in.forces.begin(), in.forces.end(), acts) &&
         std::none_of(in.drives.begin(), in.drives.end(), acts) &&
         std::none_of(in.elements.begin(), in.elements.end(), moves);
}

Body uniform_rod(const Description& in, std::string name, int a, int b, double mass) {
  const Eigen::Vector3d from = in.entities[a].at, along = in.entities[b].at - from;
  const Eigen::Matrix3d inertia =
      mass / 12.0 * (along.squaredNorm() * Eigen::Matrix3d::Identity() - along * along.transpose());
  return {std::move(name), {a, b}, mass, from + 0.5 * along, inertia};
}

}  // namespace tandem::mbs
