// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <utility>
#include <vector>

#include "quadratic_set.hpp"
#include "tandem/mbs/model.hpp"

namespace tandem::mbs {

// Equations of products are divided by the length of their longer edge as drawn, so that gradients have
// lengths of about 1 whatever the size of a mechanism: one penalty serves all. An edge between points beside
// a vector is measured in the structure's unit().

/// Points and vectors of a body beyond those that define it, as combinations of these.
std::vector<Quadratic> dependent_entities(const Description& in, const Numbering& at, int body);

/// The lengths of two edges as drawn, in m or in numbers that can be compared with those of a vector.
std::pair<double, double> lengths(const Description& in, const Edge& a, const Edge& b, double unit);

/// "distance d", "body rod: P . P".
std::string name_of(const ScalarProduct& product);
/// Numbers of the equations that keep a body rigid. One that two bodies share is of the first of them.
std::vector<int> own_equations(const Description& in, const Structure& structure, const Numbering& at,
                               int body);
Quadratic equation(const Description& in, const Numbering& at, const ScalarProduct& product, double unit);
void refuse_without_length(const Description& in, const FixedAngle& angle);
/// In the plane.
Quadratic equation(const Description& in, const Numbering& at, const FixedAngle& angle, double unit);
Quadratic equation(const Description& in, const Numbering& at, const Drive& drive);
/// The definition of a length, (|b - a|^2 - s^2) / s0 = 0, s0 as drawn.
Quadratic length_equation(const Description& in, const Numbering& at, int relative);

/// In the plane: revolute and prismatic 2, point_on_line 1. In space: spherical 3, revolute and prismatic 5,
/// universal and cylindrical 4, point_on_line 2, point_on_plane 1.
std::vector<Quadratic> equations(const Description& in, const Numbering& at, const Joint& joint);

Quadratic equation(const Description& in, const Numbering& at, const Link& link);
Quadratic equation(const Description& in, const Numbering& at, const Relation& relation);
/// One for each axis.
std::vector<Quadratic> equations(const Description& in, const Numbering& at, const Slide& slide);

}  // namespace tandem::mbs
