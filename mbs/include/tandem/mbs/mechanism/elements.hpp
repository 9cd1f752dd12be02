// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "tandem/mbs/mechanism/constraints.hpp"

namespace tandem::mbs {

/// A coordinate's share in the diagonal of the mass matrix, besides that of bodies: [kg], [kg m^2] on an
/// angle and on a vector of length 1 each of whose coordinates has it.
struct Inertia {
  Coordinate coordinate;
  double value;
};

/// A function of time where it stands, with its derivatives by time.
struct InputValue {
  double value = 0.0, rate = 0.0, acceleration = 0.0;
  bool operator==(const InputValue&) const = default;
};

/// What forces and drives depend on besides the state: given from outside (a port), or by a function of time.
struct Input {
  std::string name, unit;
  double value = std::numeric_limits<double>::quiet_NaN();  ///< until something else is given
  std::function<InputValue(double)> function = {};          ///< of time [s]; empty: given from outside
  bool smooth = true;              ///< its value, rate and acceleration are continuous, as a drive needs them
  std::vector<double> jumps = {};  ///< of the function, ascending [s]: just before it has another value
};

/// A coordinate follows an input: prescribed motion.
struct Drive {
  std::string name;
  Coordinate coordinate;
  int input;
  std::string where = {};
};

/// Between two points, along the edge, or on a relative coordinate: the force that pulls it back is
/// k1 x + k2 x^2 + ... + c1 v + c2 v^2 + ..., x the coordinate less its free value, v its rate.
struct Spring {
  std::string name;
  Edge points;        ///< or
  int relative = -1;  ///< if 0 or more
  double free = 0.0;  ///< [m or rad]
  std::vector<double> stiffness, damping;
};

/// An input times a gain acts on a point in a constant direction [N], between two points, driving them apart
/// [N], or on a relative coordinate [N or N m].
struct Force {
  enum class Kind { point, line, relative };
  std::string name;
  Kind kind;
  int index = -1;                                       ///< the point, or the relative coordinate
  Edge points = {};                                     ///< of a line
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< of a point's force; its length is a factor
  int input = -1;
  double gain = 1.0;
};

/// A quantity to be read of a mechanism:
/// - Reactions of the support on the mechanism: of a drive [N or N m], of a fixed point along an axis [N], of
///   a fixed vector [N m].
/// - Reactions on a body: what joints, springs and forces do to it at a point or vector of its own.
/// - drift: of the energy since the start [J].
/// - Residuals: the largest of Phi, Phi_q q' + Phi_t, Phi_q q'' + gamma, in the units of the constraints.
struct Output {
  enum class Kind {
    position,
    velocity,
    acceleration,
    drive_reaction,
    reaction,
    kinetic,
    potential,
    energy,
    drift,
    position_residual,
    velocity_residual,
    acceleration_residual,
    elevation,   ///< of an edge over the plane of the first two axes (in the plane: over the first) [rad]
    heading,     ///< of an edge in that plane, from the first axis, -pi to pi [rad]
    quantity,    ///< of an element
    accelerance  ///< by how much an input, through its forces, accelerates a coordinate
  };
  std::string name;
  Kind kind;
  Coordinate coordinate = {};  ///< positions to accelerations, and reactions
  int drive = -1;
  int body = -1;      ///< of a reaction on it; -1: on the whole mechanism
  Edge edge = {};     ///< of elevation and heading
  double gain = 1.0;  ///< the output is the quantity times this
  int element = -1, quantity = -1;
  int input = -1;  ///< of an accelerance
};

/// Values of an output, or of a quantity of an element, between which a mechanism is believed. Where it
/// leaves them the run ends with the sentence, or it is told once and the run goes on.
struct Limit {
  enum class OnLeaving { ignore, warn, stop };
  std::string name;
  Output signal;
  double low, high;      ///< low < high; one of them may be infinite
  std::string sentence;  ///< why: "a wheel is off the ground"
  OnLeaving on_leaving = OnLeaving::warn;
};

/// A coordinate's value that is known at the start.
struct Given {
  Coordinate coordinate;
  double value;
  std::string where = {};
};

}  // namespace tandem::mbs
