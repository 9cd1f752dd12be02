// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <vector>

#include "tandem/mbs/mechanism/description.hpp"

namespace tandem::mbs {

/// A body's share in the constant mass matrix and in the weights, by the entities that define it: points p of
/// the body are r = sum_k c_k(p) e_k with coefficients c_k that do not change (J. Garcia de Jalon, E. Bayo,
/// Kinematic and Dynamic Simulation of Multibody Systems, 1994, ch. 4).
struct BodyMass {
  std::vector<int> entities;  ///< of the description: those that define the body
  Eigen::MatrixXd mass;       ///< dim k x dim k, coordinates of an entity next to each other
  Eigen::MatrixXd weight;     ///< dim k x dim: times gravity it gives the forces on the entities [kg]
};

/// Throws Error with the body's name for a mass that is not positive, an inertia that no body has, points and
/// vectors that don't span where its mass is, and a body with no two of them apart.
BodyMass body_mass(const Description& in, const Body& body);

/// (1, at) of a point, (0, at) of a vector; as many numbers as there are dimensions, and one.
Eigen::VectorXd homogeneous(const Description& in, int entity);

/// Of the entities of a body, points before vectors, the first that are independent of those before them:
/// they define it.
std::vector<int> defining_entities(const Description& in, const Body& body);

/// What keeps those entities rigid: all scalar products of the edges from the first point to the others and
/// of the vectors, but for those of fixed ones only.
std::vector<ScalarProduct> rigid_conditions(const Description& in, const Body& body);

}  // namespace tandem::mbs
