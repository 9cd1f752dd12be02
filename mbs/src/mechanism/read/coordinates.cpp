// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "reader.hpp"
#include "tandem/mbs/mechanism/body_mass.hpp"

namespace tandem::mbs {

void Reader::read_coordinate(const std::string& name, Section& section) {
  Relative free{name, Relative::Kind::free};
  free.turns = section.required_text("unit") == "rad";
  free.at = *section.number("at");
  free.where = section.place().text();
  relative_name(section, name);
  if (const auto inertia = section.positive("inertia"))
    to_.inertias.push_back({{-1, 0, static_cast<int>(to_.relatives.size())}, *inertia});
  to_.relatives.push_back(std::move(free));
}

void Reader::read_relation(const std::string& name, Section& section) {
  Relation relation{name, {}, {}};
  relation.where = section.place().text();
  const toml::table* terms = section.table("terms");
  if (!terms || terms->empty()) section.missing("terms", "{ COORDINATE = FACTOR }");
  for (const auto& [key, node] : text::in_file_order(*terms)) {
    const std::string path = section.name("terms") + "." + key;
    relation.terms.push_back({values_.number(document_, *node, path), coordinate(section, "terms", key)});
    if (relation.terms.back().factor == 0.0)
      text::refuse(document_.place(*node), path + " is 0; allowed is another factor, or to leave it out");
  }
  read_products(section, relation);
  double as_drawn = 0.0;
  for (const auto& [factor, c] : relation.terms)
    as_drawn += factor *
                (c.relative >= 0 ? drawn(to_, to_.relatives[c.relative]) : to_.entities[c.entity].at[c.axis]);
  for (const auto& p : relation.products) as_drawn += p.factor * drawn(to_, p.a).dot(drawn(to_, p.b));
  relation.value = section.number("value").value_or(as_drawn);
  to_.relations.push_back(std::move(relation));
}

void Reader::read_products(Section& section, Relation& relation) const {
  for (Section& one : section.sections("products")) {
    const auto [a, b] = two_edges(one, "edges");
    relation.products.push_back({*one.number("factor"), a, b});
    one.refuse_unknown();
  }
}

int Reader::relative(Section& section, const std::string& key) const {
  const Coordinate c = required_coordinate(section, key);
  if (c.relative < 0) section.wrong(key, "one of a point", "an angle, a length or one of [coordinates]");
  return c.relative;
}

void Reader::read_slide(const std::string& name, Section& section) {
  Slide slide{name,
              point(section, "point", section.required_text("point")),
              carrier(section, section.required_text("on")),
              required_vector(section, "along"),
              relative(section, "coordinate"),
              section.place().text()};
  if (!(slide.along.norm() > 0.0)) section.wrong("along", "zero", "a direction");
  slide.along.normalize();
  to_.slides.push_back(std::move(slide));
}

Carrier Reader::length_carrier(Section& section, const toml::node& node) const {
  if (const auto name = node.value<std::string>()) return carrier(section, *name);
  const toml::array* names = node.as_array();
  const std::string allowed = "a body, a point, \"ground\", or an array of points and vectors";
  if (!names || names->empty()) section.wrong("between", text::described(node), allowed);
  Carrier combination{Carrier::Kind::combination};
  for (const toml::node& item : *names) {
    const auto name = item.value<std::string>();
    if (!name) section.wrong("between", text::described(item), allowed);
    combination.entities.push_back(find(entities_, section, "between", "point or vector", *name));
  }
  if (!is_point(to_, combination.entities[0]))
    section.wrong("between", "an array that begins with a vector", "one that begins with a point");
  return combination;
}

Ends Reader::ends(Section& section) const {
  const toml::array* between = section.node("between")->as_array();
  if (!between || between->size() != 2)
    section.wrong("between", text::described(*section.node("between")), "an array of two");
  const toml::node* node = section.node("ends");
  const std::string allowed = "two places apart from each other, as drawn [m]";
  if (!node) section.missing("ends", allowed);
  const toml::array* places = node->as_array();
  if (!places || places->size() != 2) section.wrong("ends", text::described(*node), allowed);
  Ends result;
  for (std::size_t k = 0; k < 2; ++k) {
    result.carriers[k] = length_carrier(section, *between->get(k));
    const toml::array* place = places->get(k)->as_array();
    if (!place || static_cast<int>(place->size()) != to_.dimension)
      section.wrong("ends", text::described(*places->get(k)), allowed);
    for (int axis = 0; axis < to_.dimension; ++axis)
      result.places[k][axis] = values_.number(document_, *place->get(static_cast<std::size_t>(axis)),
                                              fmt::format("{}[{}]", section.name("ends"), k));
  }
  if (!can_be_squared(drawn(result)))
    section.wrong("ends", fmt::format("{} m apart", drawn(result)), allowed);
  return result;
}

}  // namespace tandem::mbs
