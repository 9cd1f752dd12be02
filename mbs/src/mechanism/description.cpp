// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/description.hpp"

#include <utility>

namespace tandem::mbs {

Eigen::Vector3d drawn(const Description& in, const Edge& edge) {
  const Eigen::Vector3d to = in.entities[edge.to].at;
  return edge.from < 0 ? to : Eigen::Vector3d(to - in.entities[edge.from].at);
}

Body uniform_rod(const Description& in, std::string name, int a, int b, double mass) {
  const Eigen::Vector3d from = in.entities[a].at, along = in.entities[b].at - from;
  const Eigen::Matrix3d inertia =
      mass / 12.0 * (along.squaredNorm() * Eigen::Matrix3d::Identity() - along * along.transpose());
  return {std::move(name), {a, b}, mass, from + 0.5 * along, inertia};
}

}  // namespace tandem::mbs
