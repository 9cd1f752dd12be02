// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "form.hpp"

#include <fmt/format.h>

#include "../dense.hpp"
#include "refuse.hpp"
#include "tandem/mbs/mechanism/body_mass.hpp"

namespace tandem::mbs {

void Form::add(const Form& other, double factor) {
  constant += factor * other.constant;
  for (const auto& [coordinate, coefficient] : other.terms)
    if (factor * coefficient != 0.0) terms.emplace_back(coordinate, factor * coefficient);
}

Forms forms_of(const Description& in, const Numbering& at, int entity) {
  Forms forms;
  for (int k = 0; k < in.dimension; ++k) forms.push_back({0.0, {{at.entity[entity] + k, 1.0}}});
  return forms;
}

Forms forms_of(const Description& in, const Numbering& at, const Edge& edge) {
  Forms forms = forms_of(in, at, edge.to);
  if (edge.from < 0) return forms;
  const Forms from = forms_of(in, at, edge.from);
  for (std::size_t k = 0; k < forms.size(); ++k) forms[k].add(from[k], -1.0);
  return forms;
}

Frame::Frame(const Description& in, const Numbering& at, const Carrier& carrier, std::string where)
    : in_(in), at_(at), carrier_(carrier), where_(std::move(where)) {
  if (carrier.kind == Carrier::Kind::body) entities_ = defining_entities(in, in.bodies[carrier.index]);
  if (carrier.kind == Carrier::Kind::point) entities_ = {carrier.index};
  if (carrier.kind == Carrier::Kind::combination)
    entities_ = defining_entities(in, Body{"", carrier.entities});
}

Forms Frame::point(const Eigen::Vector3d& at) const { return forms(at, true); }
Forms Frame::direction(const Eigen::Vector3d& along) const { return forms(along, false); }

std::string Frame::name() const {
  switch (carrier_.kind) {
    case Carrier::Kind::body:
      return "body '" + in_.bodies[carrier_.index].name + "'";
    case Carrier::Kind::point:
      return "point '" + in_.entities[carrier_.index].name + "'";
    default:
      return "what '" + in_.entities[entities_[0]].name + "' and others span";
  }
}

/// The combination of the entities that has the drawn place, B c = (1, at) in homogeneous coordinates, or
/// (0, along) for a direction.
Forms Frame::forms(const Eigen::Vector3d& at, bool is_point) const {
  const int d = in_.dimension;
  Forms result(static_cast<std::size_t>(d));
  if (carrier_.kind == Carrier::Kind::ground) {
    for (int k = 0; k < d; ++k) result[k].constant = at[k];
    return result;
  }
  if (d == 2 && entities_.size() == 2) return turned_pair(at, is_point);
  const BodyCoordinates local = carrier_.kind == Carrier::Kind::point ? BodyCoordinates(in_, carrier_.index)
                                : carrier_.kind == Carrier::Kind::body
                                    ? BodyCoordinates(in_, in_.bodies[carrier_.index])
                                    : BodyCoordinates(in_, Body{"", entities_});
  Eigen::MatrixXd basis(d + 1, static_cast<int>(entities_.size()));
  for (std::size_t e = 0; e < entities_.size(); ++e) basis.col(static_cast<int>(e)) = local.of(entities_[e]);
  const Eigen::VectorXd target = is_point ? local.point(at) : local.direction(at);
  Eigen::VectorXd c = dense::solve(dense::Qr(basis), target);
  if (!((basis * c - target).norm() <= local.rounding() * (1.0 + target.norm())))
    refuse(where_, fmt::format("{} has no {} ({}, {}, {}): its points and vectors don't span it; give it one "
                               "more of them",
                               name(), is_point ? "place" : "direction", at[0], at[1], at[2]));
  for (std::size_t e = 0; e < entities_.size(); ++e)
    c[static_cast<int>(e)] *= (is_point ? 1.0 : at.norm() / local.size()) / local.factor(entities_[e]);
  for (std::size_t e = 0; e < entities_.size(); ++e) {
    const Forms own = forms_of(in_, at_, entities_[e]);
    for (int k = 0; k < d; ++k) result[k].add(own[k], c[static_cast<int>(e)]);
  }
  return result;
}

/// In the plane two points suffice: p = i + (re + im turn)(j - i), turn a quarter turn counterclockwise.
Forms Frame::turned_pair(const Eigen::Vector3d& at, bool is_point) const {
  const Edge edge = mbs::is_point(in_, entities_[1]) ? Edge{entities_[1], entities_[0]} : Edge{entities_[1]};
  const Eigen::Vector2d along = drawn(in_, edge).head(2), across(-along[1], along[0]),
                        way = is_point ? Eigen::Vector2d(at.head(2) - in_.entities[entities_[0]].at.head(2))
                                       : Eigen::Vector2d(at.head(2));
  const double re = way.dot(along) / along.squaredNorm(), im = way.dot(across) / along.squaredNorm();
  const Forms e = forms_of(in_, at_, edge);
  Forms result = is_point ? forms_of(in_, at_, entities_[0]) : Forms(2);
  result[0].add(e[0], re), result[0].add(e[1], -im);
  result[1].add(e[1], re), result[1].add(e[0], im);
  return result;
}

}  // namespace tandem::mbs
