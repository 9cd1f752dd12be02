// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <string>
#include <variant>
#include <vector>

#include "tandem/mbs/mechanism/elements.hpp"
#include "tandem/mbs/mechanism/force_element.hpp"

namespace tandem::mbs {

/// A point or a vector, shared by the bodies that name it. `at` is where it stands as drawn [m] (a vector:
/// its direction); in the plane the third number is zero.
struct Entity {
  std::string name;
  enum class Kind { point, vector } kind = Kind::point;
  bool fixed = false;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< at the start [m/s]
  std::string where = {};
  bool massless = false;  ///< belongs to no body and has no mass: equations hold it
};

/// A rigid body and the points and vectors that belong to it, as drawn: its centre and inertia are given in
/// the axes of the drawing.
struct Body {
  std::string name;
  std::vector<int> entities;                         ///< at least one point
  double mass = 0.0;                                 ///< [kg]
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< [m]
  /// About the centre [kg m^2]; in the plane (2, 2) counts.
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  bool free = false;  ///< may be connected to nothing else
  std::string where = {};
  std::vector<int> basis = {};  ///< of the entities those that define it; empty: the first that can
};

/// A mass added at a point [kg].
struct PointMass {
  std::string name;
  int point;
  double mass;
  std::string where = {};
  bool free = false;  ///< may be connected to nothing else
};

/// A parameter of a file, with its value; a word has no unit.
struct Parameter {
  std::string name, unit;
  std::variant<double, std::string> value;
};

/// A mechanism before it is assembled. Names are unique among their kind. Indices are of the lists here,
/// those of points and vectors of `entities`. `where` is what errors begin with: a file and its line, or
/// nothing.
struct Description {
  std::string name;
  std::vector<Parameter> parameters = {};             ///< whose values stand in the rest already
  int dimension = 3;                                  ///< 2: in the plane
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  ///< [m/s^2]
  std::vector<Entity> entities;
  std::vector<Body> bodies;
  std::vector<PointMass> masses;
  std::vector<ScalarProduct> products;  ///< those that hold besides the bodies' own rigidity
  std::vector<FixedAngle> fixed_angles;
  std::vector<Joint> joints;
  std::vector<Relative> relatives;
  std::vector<Link> links;
  std::vector<Relation> relations;
  std::vector<Slide> slides;
  std::vector<Inertia> inertias;
  std::vector<Input> inputs;
  std::vector<Drive> drives;
  std::vector<Spring> springs;
  std::vector<Force> forces;
  std::vector<NamedElement> elements;
  std::vector<Output> outputs;
  std::vector<Limit> limits;
  std::vector<Given> positions, velocities;  ///< that the assembly and the initial velocity problem keep
  bool equilibrium = false;                  ///< it starts where its forces balance at rest
};

/// False of a vector, and of no entity (a number below 0).
inline bool is_point(const Description& in, int entity) {
  return entity >= 0 && in.entities[static_cast<std::size_t>(entity)].kind == Entity::Kind::point;
}

/// An edge as drawn [m].
Eigen::Vector3d drawn(const Description& in, const Edge& edge);

/// How far two ends are apart as drawn [m].
double drawn(const Ends& ends);

/// A relative coordinate as drawn [rad or m]; an angle from -pi to pi.
double drawn(const Description& in, const Relative& relative);

/// True for the coordinate of an angle.
bool is_angle(const Description& in, const Coordinate& c);

/// Forces follow this input, and neither drives nor elements do.
bool only_forces_follow(const Description& in, int input);

/// A uniform thin rod between two points.
Body uniform_rod(const Description& in, std::string name, int a, int b, double mass);

}  // namespace tandem::mbs
