// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "angles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "angle_set.hpp"
#include "equations.hpp"
#include "fixed_angle_set.hpp"
#include "label.hpp"
#include "refuse.hpp"

namespace tandem::mbs {
namespace {

EdgeCoordinates coordinates(const Numbering& at, const Edge& e) {
  return {at.entity[e.to], e.from < 0 ? at.zero : at.entity[e.from]};
}

template <int Dimension>
std::unique_ptr<ConstraintSet> defined_angles(const Description& in, const Numbering& at,
                                              Structure& structure) {
  auto set = std::make_unique<AngleSet<Dimension>>();
  for (std::size_t r = 0; r < in.relatives.size(); ++r) {
    const Relative& angle = in.relatives[r];
    if (angle.kind != Relative::Kind::angle) continue;
    const Eigen::Vector3d a = drawn(in, angle.a), b = drawn(in, angle.b),
                          n = Dimension == 2 ? Eigen::Vector3d(Eigen::Vector3d::UnitZ())
                                             : in.entities[angle.axis].at;
    const auto [first, second] = lengths(in, angle.a, angle.b, structure.unit());
    const double scale = 1.0 / (std::max(first, second) * n.norm());
    const double radian = scale * a.cross(n).norm() * b.cross(n).norm() / n.norm();  // of Phi
    label(structure, {"angle " + angle.name, "rad", angle.where, radian});
    set->add({coordinates(at, angle.a), coordinates(at, angle.b),
              Dimension == 2 ? at.zero : at.entity[angle.axis], at.relative[r], scale, scale * n.norm()});
  }
  return set;
}

void refuse_parallel(const FixedAngle& angle, double drawn) {
  if (std::sin(drawn) < 1e-4)
    refuse(angle.where,
           fmt::format("fixed angle '{}' is {} rad as drawn; allowed in space is an angle other "
                       "than 0 and pi, where its gradient vanishes (a joint keeps axes parallel)",
                       angle.name, drawn));
}

}  // namespace

std::unique_ptr<ConstraintSet> angle_set(const Description& in, const Numbering& at, Structure& structure) {
  return in.dimension == 2 ? defined_angles<2>(in, at, structure) : defined_angles<3>(in, at, structure);
}

std::unique_ptr<ConstraintSet> fixed_angle_set(const Description& in, const Numbering& at,
                                               Structure& structure) {
  auto set = std::make_unique<FixedAngleSet>();
  if (in.dimension == 2) return set;
  for (const FixedAngle& angle : in.fixed_angles) {
    refuse_without_length(in, angle);
    const Eigen::Vector3d a = drawn(in, angle.a), b = drawn(in, angle.b);
    const double phi = std::atan2(a.cross(b).norm(), a.dot(b));
    refuse_parallel(angle, phi);
    const auto [first, second] = lengths(in, angle.a, angle.b, structure.unit());
    const double scale = 1.0 / std::max(first, second);
    label(structure, {"fixed angle " + angle.name, "rad", angle.where, scale * a.cross(b).norm()});
    set->add({coordinates(at, angle.a), coordinates(at, angle.b), phi, scale});
  }
  return set;
}

}  // namespace tandem::mbs
