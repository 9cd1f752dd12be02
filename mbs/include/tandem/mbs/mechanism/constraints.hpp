// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

namespace tandem::mbs {

/// The way from one point to another, or a vector (`from` is -1).
struct Edge {
  int to = -1, from = -1;
  bool operator==(const Edge&) const = default;
};

/// The scalar product of two edges stays as large as this [m^2]; of one with itself: the square of a
/// distance.
struct ScalarProduct {
  std::string name;
  Edge a, b;
  double value;
  std::string where = {};
  const char* kind = "product";  ///< what it is called besides its name: product, distance, body
};

/// The angle between two edges stays as drawn. In space it may not be 0 or pi, where its gradient vanishes.
struct FixedAngle {
  std::string name;
  Edge a, b;
  std::string where = {};
};

/// What a joint holds: a body by its number, a single point, the ground, or what moves as a constant
/// combination of points and vectors.
struct Carrier {
  enum class Kind { ground, body, point, combination } kind = Kind::ground;
  int index = -1;
  std::vector<int> entities = {};  ///< of a combination
};

/// Two carriers joined at a place of the drawing. Bodies that share a point (and in space a vector for the
/// axis) are joined there already, without equations; a joint is for those that don't.
struct Joint {
  enum class Kind { revolute, prismatic, cylindrical, spherical, universal, point_on_line, point_on_plane };
  std::string name;
  Kind kind;
  Carrier first, second;  ///< point_on_...: the point belongs to the first, line and plane to the second
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  /// Revolute (in space), prismatic, cylindrical, point_on_line: the axis. point_on_plane: the normal.
  /// Universal: the first carrier's axis, and the second's, at a right angle.
  std::array<Eigen::Vector3d, 2> axes = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  std::string where = {};
};

/// Places of two carriers, as drawn.
struct Ends {
  std::array<Carrier, 2> carriers = {};
  std::array<Eigen::Vector3d, 2> places = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
};

/// Two places stay as far apart as drawn: a massless rod.
struct Link {
  std::string name;
  Ends ends;
  std::string where = {};
};

/// A coordinate more:
/// - the angle from edge a to edge b [rad], counterclockwise about `axis` (a vector, in space), which may
///   turn over and over;
/// - the distance of two points [m], a alone, or of two places of carriers;
/// - a free one, which nothing defines but the equations and forces that name it;
/// - a state, whose rate is a quantity of first order and which has mass 1: the force on it is that rate's
///   derivative.
struct Relative {
  enum class Kind { angle, length, free, state };
  std::string name;
  Kind kind;
  Edge a = {}, b = {};
  int axis = -1;
  std::string where = {};
  Ends ends = {};      ///< of a length without edge
  bool turns = false;  ///< of a free one: in rad, else in m
  double at = 0.0;     ///< of a free one as drawn [rad or m]
};

/// Names one coordinate: axis 0 to 2 of a point or vector, or (entity -1) a relative one.
struct Coordinate {
  int entity = -1, axis = 0, relative = -1;
  bool operator==(const Coordinate&) const = default;
};

/// sum of factors times coordinates and times scalar products of edges = value.
struct Relation {
  struct Term {
    double factor;
    Coordinate coordinate;
  };
  struct Product {
    double factor;
    Edge a, b;
  };
  std::string name;
  std::vector<Term> terms;
  std::vector<Product> products;
  double value = 0.0;
  std::string where = {};
};

/// A point stands on a carrier where it is drawn, moved along a direction of the carrier by what a coordinate
/// is more than as drawn [m].
struct Slide {
  std::string name;
  int point;
  Carrier carrier;
  Eigen::Vector3d along;  ///< as drawn, of length 1
  int relative;
  std::string where = {};
};

}  // namespace tandem::mbs
