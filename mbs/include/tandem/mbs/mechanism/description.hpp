// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

namespace tandem::mbs {

/// A point or a vector, shared by the bodies that name it. `at` is where it stands as drawn [m] (a vector:
/// its direction); in the plane the third number is zero.
struct Entity {
  std::string name;
  enum class Kind { point, vector } kind = Kind::point;
  bool fixed = false;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< at the start [m/s]
};

/// A rigid body and the points and vectors that belong to it, as drawn: its centre and inertia are given in
/// the axes of the drawing.
struct Body {
  std::string name;
  std::vector<int> entities;                         ///< at least one point
  double mass = 0.0;                                 ///< [kg]
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Matrix3d inertia =
      Eigen::Matrix3d::Zero();  ///< about the centre [kg m^2]; in the plane (2, 2) counts
};

/// The way from one point to another, or a vector (`from` is -1).
struct Edge {
  int to, from = -1;
  bool operator==(const Edge&) const = default;
};

/// The scalar product of two edges stays as large as this [m^2]; of one with itself: the square of a
/// distance.
struct ScalarProduct {
  std::string name;
  Edge a, b;
  double value;
};

/// A mechanism before it is assembled. Names are unique among their kind. Indices are of `entities`.
struct Description {
  std::string name;
  int dimension = 3;                                  ///< 2: in the plane
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  ///< [m/s^2]
  std::vector<Entity> entities;
  std::vector<Body> bodies;
  std::vector<ScalarProduct> products;  ///< those that hold besides the bodies' own rigidity
};

/// An edge as drawn [m].
Eigen::Vector3d drawn(const Description& in, const Edge& edge);

/// A uniform thin rod between two points.
Body uniform_rod(const Description& in, std::string name, int a, int b, double mass);

}  // namespace tandem::mbs
