// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reader.hpp"

namespace tandem::mbs {

void Reader::read_entity(const std::string& name, Section& section, Entity::Kind kind) {
  Entity entity{name, kind};
  port_name(section, name);
  entity.at = required_vector(section, "at");
  entity.fixed = *section.flag("fixed");
  entity.massless = *section.flag("massless");
  entity.where = section.place().text();
  if (kind == Entity::Kind::vector && !(entity.at.norm() > 0.0)) section.wrong("at", "zero", "a direction");
  this->name(entities_, section, name, to_.entities.size());
  if (section.node("velocity")) {
    entity.velocity = vector(section, "velocity");
    if (entity.fixed && entity.velocity.norm() > 0.0)
      section.wrong("velocity", "not zero", "zero, as the point is fixed");
    for (int axis = 0; axis < to_.dimension && !entity.fixed; ++axis)
      to_.velocities.push_back({{static_cast<int>(to_.entities.size()), axis},
                                entity.velocity[axis],
                                section.place("velocity").text()});
  }
  to_.entities.push_back(entity);
}

void Reader::read_rod(const std::string& name, Section& section) {
  const Edge points = two_points(section, "points");
  this->name(bodies_, section, name, to_.bodies.size());
  to_.bodies.push_back(uniform_rod(to_, name, points.from, points.to, section.required_number("mass")));
  to_.bodies.back().free = *section.flag("free");
  to_.bodies.back().where = section.place().text();
}

void Reader::read_body(const std::string& name, Section& section) {
  Body body{name, {}};
  for (const std::string& entity : section.texts("points"))
    add_entity(section, "points", point(section, "points", entity), body);
  if (body.entities.empty()) section.missing("points");
  for (const std::string& entity : section.texts("vectors")) {
    const int e = find(entities_, section, "vectors", "vector", entity);
    if (to_.entities[e].kind != Entity::Kind::vector)
      section.wrong("vectors", "the point '" + entity + "'", "the names of vectors");
    add_entity(section, "vectors", e, body);
  }
  for (const std::string& entity : section.texts("basis")) {
    const int e = find(entities_, section, "basis", "point or vector", entity);
    if (std::find(body.entities.begin(), body.entities.end(), e) == body.entities.end())
      section.wrong("basis", "'" + entity + "', which is none of the body's", "its own points and vectors");
    body.basis.push_back(e);
  }
  body.mass = section.required_number("mass");
  body.centre = required_vector(section, "centre");
  body.inertia = inertia(section);
  body.free = *section.flag("free");
  body.where = section.place().text();
  this->name(bodies_, section, name, to_.bodies.size());
  to_.bodies.push_back(std::move(body));
}

void Reader::add_entity(Section& section, const std::string& key, int entity, Body& body) const {
  if (std::find(body.entities.begin(), body.entities.end(), entity) != body.entities.end())
    section.wrong(key, "'" + to_.entities[entity].name + "' twice", "names that are each there once");
  body.entities.push_back(entity);
}

void Reader::read_mass(const std::string& name, Section& section) {
  const int p = point(section, "point", section.required_text("point"));
  to_.masses.push_back(
      {name, p, section.required_number("mass"), section.place().text(), *section.flag("free")});
}

/// In the plane a number; in space three rows of three.
Eigen::Matrix3d Reader::inertia(Section& section) const {
  Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
  if (to_.dimension == 2) {
    if (!section.node("inertia")) section.missing("inertia");
    tensor(2, 2) = *section.positive("inertia");
    return tensor;
  }
  const std::string allowed = "three arrays of three numbers [kg m^2], symmetric";
  const toml::node* node = section.node("inertia");
  if (!node) section.missing("inertia");
  const toml::array* rows = node->as_array();
  for (int r = 0; r < 3; ++r) {
    const toml::array* row = rows && rows->size() == 3 ? rows->get(r)->as_array() : nullptr;
    if (!row || row->size() != 3) section.wrong("inertia", text::described(*node), allowed);
    for (int c = 0; c < 3; ++c)
      tensor(r, c) = values_.number(document_, *row->get(c), section.name("inertia"));
  }
  const double largest = tensor.cwiseAbs().maxCoeff();
  if (!(largest > 0.0))
    section.wrong("inertia", "zero",
                  "that of a body with an extent (the mass of a point belongs in [masses])");
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < r; ++c)
      if (std::abs(tensor(r, c) - tensor(c, r)) > 1e-12 * largest)
        section.wrong("inertia",
                      fmt::format("{} in row {}, column {}, and {} in row {}, column {}", tensor(c, r), c + 1,
                                  r + 1, tensor(r, c), r + 1, c + 1),
                      allowed);
  return 0.5 * (tensor + tensor.transpose());
}

}  // namespace tandem::mbs
