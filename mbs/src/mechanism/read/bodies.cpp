// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "reader.hpp"

namespace tandem::mbs {

void Reader::read_entity(const std::string& name, Section& section, Entity::Kind kind) {
  Entity entity{name, kind};
  entity.at = required_vector(section, "at", fmt::format("its {} coordinates as drawn [m]", to_.dimension));
  entity.fixed = section.flag("fixed").value_or(false);
  entity.where = section.place().text();
  if (kind == Entity::Kind::vector && !(entity.at.norm() > 0.0)) section.wrong("at", "zero", "a direction");
  this->name(entities_, section, name, to_.entities.size());
  if (const auto velocity = vector(section, "velocity")) {
    entity.velocity = *velocity;
    if (entity.fixed && velocity->norm() > 0.0)
      section.wrong("velocity", "not zero", "zero, as the point is fixed");
    for (int axis = 0; axis < to_.dimension && !entity.fixed; ++axis)
      to_.velocities.push_back({{static_cast<int>(to_.entities.size()), axis},
                                (*velocity)[axis],
                                section.place("velocity").text()});
  }
  to_.entities.push_back(entity);
}

void Reader::read_rod(const std::string& name, Section& section) {
  const Edge points = two_points(section, "points");
  this->name(bodies_, section, name, to_.bodies.size());
  to_.bodies.push_back(
      uniform_rod(to_, name, points.from, points.to, required_positive(section, "mass", "kg")));
  to_.bodies.back().free = section.flag("free").value_or(false);
  to_.bodies.back().where = section.place().text();
}

void Reader::read_body(const std::string& name, Section& section) {
  Body body{name, {}};
  for (const std::string& entity : section.texts("points"))
    body.entities.push_back(point(section, "points", entity));
  if (body.entities.empty()) section.missing("points", "the names of one point or more");
  for (const std::string& entity : section.texts("vectors"))
    body.entities.push_back(find(entities_, section, "vectors", "vector", entity));
  body.mass = required_positive(section, "mass", "kg");
  body.centre = required_vector(section, "centre", "the centre of mass as drawn [m]");
  body.inertia = inertia(section);
  body.free = section.flag("free").value_or(false);
  body.where = section.place().text();
  this->name(bodies_, section, name, to_.bodies.size());
  to_.bodies.push_back(std::move(body));
}

void Reader::read_mass(const std::string& name, Section& section) {
  const int p = point(section, "point", section.required_text("point", "the name of a point"));
  to_.masses.push_back({name, p, required_positive(section, "mass", "kg"), section.place().text()});
}

/// In the plane a number; in space three rows of three.
Eigen::Matrix3d Reader::inertia(Section& section) const {
  Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
  if (to_.dimension == 2) {
    tensor(2, 2) = required_positive(section, "inertia", "kg m^2");
    return tensor;
  }
  const std::string allowed = "three arrays of three numbers [kg m^2], symmetric";
  const toml::node* node = section.node("inertia");
  if (!node) section.missing("inertia", allowed);
  const toml::array* rows = node->as_array();
  for (int r = 0; r < 3; ++r) {
    const toml::array* row = rows && rows->size() == 3 ? rows->get(r)->as_array() : nullptr;
    if (!row || row->size() != 3) section.wrong("inertia", text::described(*node), allowed);
    for (int c = 0; c < 3; ++c)
      tensor(r, c) = text::number_of(document_, *row->get(c), section.name("inertia"));
  }
  if (tensor != tensor.transpose()) section.wrong("inertia", "not symmetric", allowed);
  return tensor;
}

}  // namespace tandem::mbs
