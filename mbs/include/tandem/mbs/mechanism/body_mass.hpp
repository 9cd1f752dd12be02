// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <vector>

#include "tandem/mbs/mechanism/description.hpp"

namespace tandem::mbs {

/// A body's share in the constant mass matrix and in the weights, by the entities that define it. Points p of
/// the body are r = sum_k c_k(p) e_k with coefficients c_k that do not change (J. Garcia de Jalon, E. Bayo,
/// Kinematic and Dynamic Simulation of Multibody Systems, 1994, ch. 4).
struct BodyMass {
  std::vector<int> entities;  ///< of the description: those that define the body
  Eigen::MatrixXd mass;       ///< dim k x dim k, coordinates of an entity next to each other
  Eigen::MatrixXd weight;     ///< dim k x dim: times gravity it gives the forces on the entities [kg]
};

/// Throws Error with the body's name for:
/// - a mass that is not positive;
/// - a size that can't be squared;
/// - an inertia that no body has;
/// - points and vectors that don't span where its mass is;
/// - a body with no two of them apart.
BodyMass body_mass(const Description& in, const Body& body);

/// True for lengths [m] whose squares and inverse squares are numbers of full precision: 1e-100 to 1e100.
inline bool can_be_squared(double length) { return length >= 1e-100 && length <= 1e100; }

/// Homogeneous coordinates about a body's first point in units of its size, so that a threshold means the
/// same for a small body, a large one, and one far from the origin.
class BodyCoordinates {
 public:
  /// Size: the largest distance of the body's points from the first; with one point, that of its mass.
  BodyCoordinates(const Description& in, const Body& body);
  /// Of a single point: its distance from the origin.
  BodyCoordinates(const Description& in, int point);

  double size() const { return size_; }                      ///< [m]
  const Eigen::Vector3d& origin() const { return origin_; }  ///< [m]
  /// What rounding and a drawing's last digits may make of a zero.
  double rounding() const { return rounding_; }
  /// (1, place) and (0, direction of length 1); as many numbers as there are dimensions, and one.
  Eigen::VectorXd point(const Eigen::Vector3d& at) const;
  Eigen::VectorXd direction(const Eigen::Vector3d& along) const;
  Eigen::VectorXd of(int entity) const;
  /// What multiplies of(entity) in a linear combination of points and vectors: 1, or a vector's length by the
  /// size.
  double factor(int entity) const;

 private:
  void measure(double size);

  const Description& in_;
  Eigen::Vector3d origin_;
  double size_, rounding_;
};

/// Of the entities of a body, points before vectors, the first that are independent of those before them:
/// they define it.
std::vector<int> defining_entities(const Description& in, const Body& body);

/// What keeps those entities rigid: all scalar products of the edges from the first point to the others and
/// of the vectors, but for those of fixed ones only.
std::vector<ScalarProduct> rigid_conditions(const Description& in, const Body& body);

}  // namespace tandem::mbs
