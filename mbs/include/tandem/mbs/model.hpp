// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tandem/mbs/sparse/pattern.hpp"

namespace tandem::mbs {

/// What does not change while a model moves.
struct Structure {
  int coordinates = 0;  ///< Length of q and its derivatives: the variables, then coordinates that stay fixed.
  int variables = 0;    ///< N.
  int constraints = 0;  ///< M.
  Matrix mass;          ///< M, n x n, both triangles, constant.
  Pattern jacobian;     ///< Of Phi_q^T, n x m: a column for each constraint.
  Pattern stiffness;    ///< Of K and C, n x n; no entries if forces depend on neither q nor q'.
  /// States of first order, each the rate of a variable that neither constraints nor masses connect with
  /// others: a tangent is factorized without them (sparse/condensed_states.hpp).
  std::vector<int> states = {};
  /// K and C are symmetric, but for rows and columns of states. If not, say so: a tangent with both triangles
  /// of them is factorized by LU.
  bool symmetric_forces = true;
  /// Entries that a model writes behind those of the pattern (derivatives by fixed coordinates), in the
  /// arrays of values.
  int jacobian_extra = 0, stiffness_extra = 0;
  std::vector<std::string> variable_names, constraint_names;
  /// By constraint, in the unit of its Phi: a state that is off by a hundredth of it is no state of the
  /// mechanism any more. All 1 if there are none.
  std::vector<double> constraint_sizes = {};
  /// For sentences that refuse; may be left empty: the unit in which each constraint is off (Off), and its
  /// place, "FILE:LINE".
  std::vector<std::string> constraint_units, constraint_places;
  double length = 1.0;  ///< Of its parts [m]: default tolerances are in proportion to it.
  /// Where coordinates are lengths and pure numbers both and `length` is far from 1 m: the factor that makes
  /// each coordinate and each Phi a length [m]. None: all 1. Steppers and the initial problems go by lengths
  /// (coordinate x scale), so that one tolerance and one penalty serve all.
  std::vector<double> coordinate_scales = {}, constraint_scales = {};
  /// What q as described leaves of a change (Euclidean): no default tolerance is below.
  double rounding = 0.0;

  /// The tolerance for changes of q that is set [m]; 0: this fraction of `length`.
  double tolerance(double set, double fraction) const {
    return set > 0.0 ? set : std::max(fraction * length, rounding);
  }
  /// The power of 1024 nearest to `length` [m]: 1 from 0.03 to 32 m.
  double unit() const { return std::exp2(10.0 * std::round(0.1 * std::log2(length))); }
  /// Behind a number in a sentence: " m", " rad/s" of a rate, nothing for a pure number.
  std::string unit_of(int constraint, bool rate = false) const {
    if (constraint_units.empty()) return "";
    const std::string& unit = constraint_units[static_cast<std::size_t>(constraint)];
    if (rate) return " " + unit + "/s";
    return unit == "1" ? "" : " " + unit;
  }
  int jacobian_values() const { return jacobian.size() + jacobian_extra; }  ///< length of that array
  int stiffness_values() const { return stiffness.size() + stiffness_extra; }
};

/// Where a model stands. Vectors have `coordinates` entries (lambda: `constraints`).
struct State {
  double time = 0.0;        ///< [s]
  Eigen::VectorXd q, v, a;  ///< positions, velocities, accelerations; those of fixed ones are zero
  Eigen::VectorXd lambda;   ///< multipliers: the constraint forces are -Phi_q^T lambda
};

/// How sentences tell that a constraint is off: a rod by r - l, an angle by rad.
struct Off {
  double now;      ///< in the unit of its constraint
  double per_phi;  ///< what 1 of Phi is in that unit, for a little of it; of either sign
};

/// A multibody system M q'' + Phi_q^T lambda = Q(t, q, q'), Phi(t, q) = 0, with constant M. Pointers are to
/// arrays of the sizes in structure(); values of matrices are in the order of their patterns. at_time() comes
/// before the others.
class Model {
 public:
  virtual ~Model() = default;
  virtual const Structure& structure() const = 0;

  /// Fixes what depends on time alone: inputs, prescribed motions.
  virtual void at_time(double t) = 0;

  /// Phi, and the values of Phi_q^T.
  virtual void constraints(const double* q, double* phi, double* jacobian) const = 0;
  /// Partial derivative of Phi by time.
  virtual void constraint_rates(const double* q, double* phi_t) const = 0;
  /// gamma in Phi'' = Phi_q q'' + gamma = 0.
  virtual void constraint_accelerations(const double* q, const double* v, double* gamma) const = 0;

  /// How far a constraint is off at q, where its Phi is `phi`.
  virtual Off off(int /*constraint*/, const double* /*q*/, double phi) const { return {phi, 1.0}; }

  /// Q, of the variables.
  virtual void forces(const double* q, const double* v, double* force) const = 0;
  /// K = -dQ/dq and C = -dQ/dq' on the pattern `stiffness`.
  virtual void force_derivatives(const double* q, const double* v, double* k, double* c) const = 0;

  /// Kinetic plus potential energy [J]; forces given from outside have none.
  virtual double energy(const double* q, const double* v) const = 0;
};

}  // namespace tandem::mbs
