// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "equations.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "off.hpp"
#include "refuse.hpp"
#include "tandem/mbs/mechanism/body_mass.hpp"

namespace tandem::mbs {
namespace {

constexpr std::array axis_names = {"x", "y", "z"};

/// a x b in the plane, times a factor.
void add_cross(Quadratic& to, const Forms& a, const Forms& b, double factor) {
  to.add_product(a[0], b[1], factor);
  to.add_product(a[1], b[0], -factor);
}

Forms difference(Forms a, const Forms& b) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k].add(b[k], -1.0);
  return a;
}

/// Two unit vectors at right angles to an axis (a unit vector, or zero for none) and to each other; in the
/// plane one.
std::vector<Eigen::Vector3d> across(int dimension, const Eigen::Vector3d& axis) {
  if (dimension == 2) return {{-axis[1], axis[0], 0.0}};
  const Eigen::Vector3d first = axis.norm() > 0.0 ? axis.unitOrthogonal() : axis;
  return {first, axis.cross(first)};
}

/// Writes the equations of one joint.
class JointEquations {
 public:
  JointEquations(const Description& in, const Numbering& at, const Joint& joint)
      : in_(in),
        joint_(joint),
        first_(in, at, joint.first, joint.where),
        second_(in, at, joint.second, joint.where),
        axis_(joint.axes[0].normalized()),
        across_(across(in.dimension, axis_)) {}

  std::vector<Quadratic> write() {
    using enum Joint::Kind;
    const Joint::Kind kind = joint_.kind;
    const bool space = in_.dimension == 3;
    if (kind == spherical || kind == universal || kind == revolute) same_place();
    if (kind == prismatic || kind == cylindrical || kind == point_on_line) on_line();
    if (kind == point_on_plane) along(axis_, "height");
    if (space && (kind == revolute || kind == prismatic || kind == cylindrical)) parallel();
    if (kind == prismatic) no_turn();
    if (kind == universal)
      product(first_.direction(axis_), second_.direction(joint_.axes[1].normalized()), "angle");
    return std::move(equations_);
  }

 private:
  Quadratic& next(const std::string& what) {
    equations_.push_back({"joint " + joint_.name + ": " + what});
    equations_.back().where = joint_.where;
    return equations_.back();
  }
  Forms between() const { return difference(first_.point(joint_.at), second_.point(joint_.at)); }

  void same_place() {
    const Forms gap = between();
    for (int k = 0; k < in_.dimension; ++k) next(axis_names.at(k)).add(gap[k], 1.0);
  }
  /// The first's place does not leave the second's in that direction of the second.
  void along(const Eigen::Vector3d& direction, const std::string& what) {
    next(what).add_product(between(), second_.direction(direction), 1.0);
  }
  void on_line() {
    for (std::size_t k = 0; k < across_.size(); ++k) along(across_[k], "across " + std::to_string(k + 1));
  }
  void parallel() {
    for (int k = 0; k < 2; ++k)
      product(first_.direction(axis_), second_.direction(across_[k]), "axis " + std::to_string(k + 1));
  }
  /// About the axis, or in the plane.
  void no_turn() {
    const auto& turned = in_.dimension == 3 ? across_[1] : axis_;
    product(first_.direction(across_[0]), second_.direction(turned), "turn");
  }
  /// Two directions stay at a right angle.
  void product(const Forms& a, const Forms& b, const std::string& what) {
    next(what).add_product(a, b, 1.0);
    equations_.back().unit = "1";
  }

  const Description& in_;
  const Joint& joint_;
  Frame first_, second_;
  Eigen::Vector3d axis_;
  std::vector<Eigen::Vector3d> across_;
  std::vector<Quadratic> equations_;
};

Forms way(const Description& in, const Numbering& at, const Ends& ends, const std::string& where) {
  const auto place = [&](std::size_t k) {
    return Frame(in, at, ends.carriers[k], where).point(ends.places[k]);
  };
  return difference(place(1), place(0));
}

bool right_angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::abs(a.dot(b)) <= 1e-9 * a.norm() * b.norm();
}

void check(const Description& in, const Joint& joint) {
  using enum Joint::Kind;
  if (joint.first.kind == joint.second.kind && joint.first.index == joint.second.index)
    refuse(joint.where,
           "joint '" + joint.name +
               "' joins a carrier with itself; allowed are two bodies, or a body and the ground");
  const bool needs_axis = joint.kind != spherical && (in.dimension == 3 || joint.kind != revolute);
  if (needs_axis && !(joint.axes[0].norm() > 0.0))
    refuse(joint.where, "joint '" + joint.name + "' has an axis of length 0; allowed is a direction");
  if (joint.kind == universal &&
      (!(joint.axes[1].norm() > 0.0) || !right_angle(joint.axes[0], joint.axes[1])))
    refuse(joint.where, "joint '" + joint.name + "' has axes that are not at a right angle");
}

}  // namespace

std::vector<Quadratic> dependent_entities(const Description& in, const Numbering& at, int number) {
  const Body& body = in.bodies[number];
  const auto defining = defining_entities(in, body);
  const Frame frame(in, at, {Carrier::Kind::body, number}, body.where);
  std::vector<Quadratic> equations;
  for (const int e : body.entities) {
    const Entity& entity = in.entities[e];
    if (std::find(defining.begin(), defining.end(), e) != defining.end()) continue;
    const Forms own = forms_of(in, at, e), from = entity.kind == Entity::Kind::point
                                                      ? frame.point(entity.at)
                                                      : frame.direction(entity.at);
    for (int k = 0; k < in.dimension; ++k) {
      equations.push_back({fmt::format("body {}: {}.{}", body.name, entity.name, axis_names[k])});
      equations.back().where = body.where;
      if (entity.kind == Entity::Kind::vector) equations.back().unit = "1";
      equations.back().add(own[k], 1.0);
      equations.back().add(from[k], -1.0);
    }
  }
  return equations;
}

std::string name_of(const ScalarProduct& p) { return std::string(p.kind) + " " + p.name; }

std::vector<int> own_equations(const Description& in, const Structure& s, const Numbering& at, int body) {
  std::set<std::string> names;
  for (const ScalarProduct& p : rigid_conditions(in, in.bodies[static_cast<std::size_t>(body)]))
    names.insert(name_of(p));
  for (const Quadratic& q : dependent_entities(in, at, body)) names.insert(q.name);
  std::vector<int> numbers;
  for (int e = 0; e < s.constraints; ++e)
    if (names.contains(s.constraint_names[static_cast<std::size_t>(e)])) numbers.push_back(e);
  return numbers;
}

std::pair<double, double> lengths(const Description& in, const Edge& a, const Edge& b, double unit) {
  const bool alike = (a.from < 0) == (b.from < 0);
  const auto length = [&](const Edge& e) { return drawn(in, e).norm() / (alike || e.from < 0 ? 1.0 : unit); };
  return {length(a), length(b)};
}

Quadratic equation(const Description& in, const Numbering& at, const ScalarProduct& p, double unit) {
  const auto [a, b] = lengths(in, p.a, p.b, unit);
  const double length = std::max(a, b);
  if (!(length > 0.0))
    refuse(p.where, "scalar product '" + p.name + "' is of two edges of length 0; allowed is one of them");
  const double scale = 1.0 / length;
  Quadratic e{name_of(p), -scale * p.value};
  e.where = p.where;
  if (p.a.from < 0 && p.b.from < 0) e.unit = "1";
  e.size = length * ((p.a.from < 0) == (p.b.from < 0) ? 1.0 : unit);
  e.add_product(forms_of(in, at, p.a), forms_of(in, at, p.b), scale);
  return e;
}

void refuse_without_length(const Description& in, const FixedAngle& angle) {
  if (!(drawn(in, angle.a).norm() * drawn(in, angle.b).norm() > 0.0))
    refuse(angle.where, "fixed angle '" + angle.name + "' is of an edge of length 0");
}

/// With the drawn angle phi: (a x b) cos(phi) - (a . b) sin(phi) = 0, whose gradient never vanishes.
Quadratic equation(const Description& in, const Numbering& at, const FixedAngle& angle, double unit) {
  refuse_without_length(in, angle);
  const Eigen::Vector3d a = drawn(in, angle.a), b = drawn(in, angle.b);
  const auto [first, second] = lengths(in, angle.a, angle.b, unit);
  const double phi = std::atan2(a.cross(b)[2], a.dot(b)), scale = 1.0 / std::max(first, second);
  const Forms fa = forms_of(in, at, angle.a), fb = forms_of(in, at, angle.b);
  Quadratic e{"fixed angle " + angle.name};
  e.where = angle.where;
  e.unit = "rad";
  e.size = scale * a.norm() * b.norm();
  e.off = off_of_angle(fa, fb, phi, scale);
  add_cross(e, fa, fb, scale * std::cos(phi));
  e.add_product(fa, fb, -scale * std::sin(phi));
  return e;
}

Quadratic equation(const Description& in, const Numbering& at, const Drive& drive) {
  Quadratic e{"drive " + drive.name};
  e.where = drive.where;
  e.unit = in.inputs[static_cast<std::size_t>(drive.input)].unit;
  e.linear.push_back({1.0, at.of(drive.coordinate)});
  e.input = drive.input;
  return e;
}

Quadratic length_equation(const Description& in, const Numbering& at, int relative) {
  const Relative& length = in.relatives[relative];
  const Forms edge = length.a.to >= 0 ? forms_of(in, at, length.a) : way(in, at, length.ends, length.where);
  const int s = at.relative[relative];
  Quadratic e{"length " + length.name};
  e.where = length.where;
  e.size = drawn(in, length);
  const double scale = 1.0 / e.size;
  e.add_product(edge, edge, scale);
  e.products.push_back({-scale, s, s});
  e.off = off_of_length(s, scale);
  return e;
}

Quadratic equation(const Description& in, const Numbering& at, const Link& link) {
  const double length = drawn(link.ends);
  const Forms edge = way(in, at, link.ends, link.where);
  Quadratic e{"distance " + link.name, -length};
  e.where = link.where;
  e.size = length;
  e.off = [=](const double*, double phi) { return off_of_distance(length, phi); };
  e.add_product(edge, edge, 1.0 / length);
  return e;
}

Quadratic equation(const Description& in, const Numbering& at, const Relation& relation) {
  Quadratic e{"relation " + relation.name, -relation.value};
  e.where = relation.where;
  for (const auto& term : relation.terms) {
    if (is_angle(in, term.coordinate)) e.unit = "rad";
    e.linear.push_back({term.factor, at.of(term.coordinate)});
  }
  for (const auto& p : relation.products)
    e.add_product(forms_of(in, at, p.a), forms_of(in, at, p.b), p.factor);
  return e;
}

std::vector<Quadratic> equations(const Description& in, const Numbering& at, const Slide& slide) {
  const Frame frame(in, at, slide.carrier, slide.where);
  const Forms gap = difference(forms_of(in, at, slide.point), frame.point(in.entities[slide.point].at)),
              along = frame.direction(slide.along);
  const Form way{-in.relatives[slide.relative].at, {{at.relative[slide.relative], 1.0}}};
  std::vector<Quadratic> all;
  for (int k = 0; k < in.dimension; ++k) {
    Quadratic e{"slide " + slide.name + ": " + axis_names[k]};
    e.where = slide.where;
    e.add(gap[k], 1.0);
    e.add_product(way, along[k], -1.0);
    all.push_back(std::move(e));
  }
  return all;
}

std::vector<Quadratic> equations(const Description& in, const Numbering& at, const Joint& joint) {
  check(in, joint);
  return JointEquations(in, at, joint).write();
}

}  // namespace tandem::mbs
