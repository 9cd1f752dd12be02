// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "view/place.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace tandem::view {
namespace {

using Json = nlohmann::ordered_json;
using mbs::Description;

const Eigen::Vector3d& at_of(const Description& in, int e) {
  return in.entities[static_cast<std::size_t>(e)].at;
}

/// In the plane a point and another, or a vector, suffice: i + (along + across turn) u.
Json turned_pair(const Description& in, int i, int j, const Eigen::Vector3d& at) {
  const Eigen::Vector3d u = mbs::drawn(in, {j, is_point(in, j) ? i : -1}), way = at - at_of(in, i);
  const double along = way.dot(u) / u.squaredNorm(),
               across = (u[0] * way[1] - u[1] * way[0]) / u.squaredNorm();
  Json terms = Json::array({{j, along, across}});
  terms.push_back(is_point(in, j) ? Json{i, 1.0 - along, -across} : Json{i, 1.0, 0.0});
  return {{"terms", terms}};
}

/// Coefficients c of least length with sum c_k (1, e_k) = (1, at), 0 in place of 1 for a vector.
Json combination(const Description& in, const std::vector<int>& entities, const Eigen::Vector3d& at) {
  Eigen::MatrixXd basis(4, static_cast<int>(entities.size()));
  for (std::size_t k = 0; k < entities.size(); ++k)
    basis.col(static_cast<int>(k)) << at_of(in, entities[k]), is_point(in, entities[k]) ? 1.0 : 0.0;
  Eigen::Vector4d target;
  target << at, 1.0;
  const Eigen::VectorXd c = basis.completeOrthogonalDecomposition().solve(target);
  Json terms = Json::array();
  for (std::size_t k = 0; k < entities.size(); ++k)
    if (const double share = c[static_cast<int>(k)]; std::abs(share) > 1e-12)
      terms.push_back({entities[k], share, 0.0});
  return {{"terms", terms}};
}

}  // namespace

Json place_on(const Description& in, const std::vector<int>& entities, const Eigen::Vector3d& at) {
  for (const int e : entities)
    if (is_point(in, e) && at_of(in, e) == at) return e;
  if (entities.empty()) return {{"constant", {at[0], at[1], at[2]}}, {"terms", Json::array()}};
  if (in.dimension == 2 && entities.size() == 2 && is_point(in, entities[0]))
    return turned_pair(in, entities[0], entities[1], at);
  return combination(in, entities, at);
}

/// A uniform block has the second moments m s^2 / 12 of its edges s along its principal axes.
std::vector<Eigen::Vector3d> block(const mbs::Body& body) {
  const Eigen::Matrix3d second = 0.5 * body.inertia.trace() * Eigen::Matrix3d::Identity() - body.inertia;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(second);
  const Eigen::Vector3d half = (3.0 * axes.eigenvalues().cwiseMax(0.0) / body.mass).cwiseSqrt();
  std::vector<Eigen::Vector3d> corners;
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector3d sign((k & 1) != 0 ? 1.0 : -1.0, (k & 2) != 0 ? 1.0 : -1.0,
                               (k & 4) != 0 ? 1.0 : -1.0);
    corners.emplace_back(body.centre + axes.eigenvectors() * half.cwiseProduct(sign));
  }
  return corners;
}

}  // namespace tandem::view
