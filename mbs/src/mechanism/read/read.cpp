// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/read.hpp"

#include <fmt/format.h>

#include "reader.hpp"
#include "tandem/mbs/mechanism/body_mass.hpp"
#include "tandem/mbs/mechanism/keys.hpp"
#include "tandem/nearest.hpp"

namespace tandem::mbs {

using text::refuse;

static constexpr const char* not_in_names = "[],\" \t\r\n";  // of ports, which are columns of results

Description Reader::read() {
  Section root(document_, language_, &values_);
  read_name(root);
  root.text("description");
  for (const text::FileParameter& p : text::read_parameters(root, given_, values_))
    to_.parameters.push_back({p.name, p.unit, p.value});
  read_dimension(root);
  to_.gravity = vector(root, "gravity");
  using Read = void (Reader::*)(const std::string&, Section&);
  each(root, "points", [this](auto& name, Section& s) { read_entity(name, s, Entity::Kind::point); });
  each(root, "vectors", [this](auto& name, Section& s) { read_entity(name, s, Entity::Kind::vector); });
  const std::pair<const char*, Read> tables[] = {
      {"rods", &Reader::read_rod},           {"bodies", &Reader::read_body},
      {"masses", &Reader::read_mass},        {"distances", &Reader::read_distance},
      {"products", &Reader::read_product},   {"fixed_angles", &Reader::read_fixed_angle},
      {"joints", &Reader::read_joint},       {"angles", &Reader::read_angle},
      {"lengths", &Reader::read_length},     {"coordinates", &Reader::read_coordinate},
      {"relations", &Reader::read_relation}, {"slides", &Reader::read_slide},
      {"inputs", &Reader::read_input},       {"drives", &Reader::read_drive},
      {"springs", &Reader::read_spring},     {"forces", &Reader::read_force},
      {"elements", &Reader::read_element},   {"outputs", &Reader::read_output},
      {"limits", &Reader::read_limit}};
  for (const auto& [key, read] : tables)
    each(root, key, [this, read = read](auto& name, Section& s) { (this->*read)(name, s); });
  read_initial(root);
  root.section("run");   // for whoever runs it
  root.section("view");  // for whoever draws it
  root.refuse_unknown();
  refuse_unused_inputs(root);
  if (to_.bodies.empty() && to_.masses.empty() && to_.inertias.empty())
    root.missing("rods",
                 "a table [rods.NAME], [bodies.NAME] or [masses.NAME] for each body, or [coordinates.NAME] "
                 "with inertia");
  return std::move(to_);
}

void Reader::read_name(Section& root) {
  const auto name = root.text("name");
  to_.name = name.value_or(document_.file());
  if (name && (name->empty() || name->find_first_of(not_in_names) != std::string::npos))
    root.wrong("name", "'" + *name + "'", "one letter or more, without [ ] , \" and blanks");
}

void Reader::read_dimension(Section& root) {
  const double dimension = root.required_number("dimension");
  if (dimension != 2.0 && dimension != 3.0)
    root.wrong("dimension", fmt::format("{}", dimension), "2 for the plane, 3 for space");
  to_.dimension = static_cast<int>(dimension);
}

/// Calls read(name, section) for each table below a key, in the order of the file.
template <class Read>
void Reader::each(Section& root, const std::string& key, const Read& read) {
  auto table = root.section(key);
  if (!table) return;
  for (auto& [name, section] : table->named_sections()) {
    if (name.empty())
      refuse(section.place(), key + " has a name of no letters; allowed is one letter or more");
    read(name, section);
    section.refuse_unknown();
  }
}

/// As many numbers as the mechanism has dimensions; the third is zero in the plane.
Eigen::Vector3d Reader::vector(Section& section, const std::string& key) const {
  const toml::node* node = section.node(key);
  if (!node) return Eigen::Vector3d::Zero();
  const toml::array* array = node->as_array();
  if (!array || static_cast<int>(array->size()) != to_.dimension)
    section.wrong(key, array ? fmt::format("an array of {}", array->size()) : text::described(*node),
                  fmt::format("an array of {} numbers", to_.dimension));
  Eigen::Vector3d value = Eigen::Vector3d::Zero();
  for (int i = 0; i < to_.dimension; ++i)
    value[i] = values_.number(document_, *array->get(i), fmt::format("{}[{}]", section.name(key), i));
  return value;
}

Eigen::Vector3d Reader::required_vector(Section& section, const std::string& key) const {
  if (!section.node(key)) section.missing(key);
  return vector(section, key);
}

std::vector<double> Reader::numbers(Section& section, const std::string& key) const {
  const toml::node* node = section.node(key);
  if (!node) return {};
  const toml::array* array = node->as_array();
  if (!array) return {values_.number(document_, *node, section.name(key))};
  if (array->empty()) section.wrong(key, "an empty array", "a number, or an array of one or more");
  std::vector<double> all;
  for (const toml::node& item : *array)
    all.push_back(values_.number(document_, item, fmt::format("{}[{}]", section.name(key), all.size())));
  return all;
}

void Reader::name(Names& names, const Section& section, const std::string& name, std::size_t index) const {
  if (!names.emplace(name, static_cast<int>(index)).second)
    refuse(section.place(), "the name '" + name + "' is there twice; allowed is a name of its own");
}

void Reader::relative_name(const Section& section, const std::string& name) {
  this->name(relatives_, section, name, to_.relatives.size());
  if (name.find('.') != std::string::npos)
    refuse(section.place(),
           "the name '" + name + "' has a dot, as coordinates of points have; allowed is a name without");
}

void Reader::port_name(const Section& section, const std::string& name) const {
  if (name.find_first_of(not_in_names) != std::string::npos)
    refuse(section.place(),
           "the name '" + name + "' is no port's; allowed are names without [ ] , \" and blanks");
}

int Reader::find(const Names& names, const Section& section, const std::string& key, const std::string& kind,
                 const std::string& name) const {
  if (const auto it = names.find(name); it != names.end()) return it->second;
  std::vector<std::string> known;
  for (const auto& [other, index] : names) known.push_back(other);
  refuse(section.place(key), section.name(key) + ": " + unknown(kind, name, known));
}

int Reader::point(Section& section, const std::string& key, const std::string& name) const {
  const int e = find(entities_, section, key, "point", name);
  if (!is_point(to_, e)) section.wrong(key, "the vector '" + name + "'", "the name of a point");
  return e;
}

int Reader::vector_named(Section& section, const std::string& key, const std::string& name,
                         const std::string& allowed) const {
  const int e = find(entities_, section, key, "vector", name);
  if (is_point(to_, e)) section.wrong(key, "the point '" + name + "'", allowed);
  return e;
}

Edge Reader::two_points(Section& section, const std::string& key) const {
  const std::string allowed = "the names of two points";
  const auto names = section.texts(key);
  if (!section.node(key)) section.missing(key);
  if (names.size() != 2) section.wrong(key, fmt::format("{} names", names.size()), allowed);
  const Edge edge{point(section, key, names[1]), point(section, key, names[0])};
  if (edge.to == edge.from) section.wrong(key, "'" + names[0] + "' twice", allowed);
  const double apart = drawn(to_, edge).stableNorm();
  if (!(apart > 0.0))
    refuse(section.place(key),
           section.name(key) + " are drawn at one place; allowed is a distance above 0 m");
  if (!can_be_squared(apart))
    refuse(section.place(key),
           fmt::format("{} are drawn {} m apart; allowed are 1e-100 to 1e100 m", section.name(key), apart));
  return edge;
}

void Reader::only_one(Section& section, const std::string& owner,
                      const std::vector<std::string>& keys) const {
  std::vector<std::string> given;
  for (const std::string& key : keys)
    if (section.node(key)) given.push_back(key);
  if (given.empty()) section.missing(keys[0], "one of " + listed(keys));
  if (given.size() > 1)
    refuse(section.place(), owner + " has " + listed(given) + "; allowed is one of " + listed(keys));
}

Edge Reader::edge(Section& section, const std::string& key, const toml::node* node) const {
  const std::string allowed = "the name of a vector, or an array of two points";
  if (!node) section.missing(key, allowed);
  const toml::array* array = node->as_array();
  if (node->is_string()) return {vector_named(section, key, section.text_of(*node, key), allowed)};
  if (!array || array->size() != 2 || !array->get(0)->is_string() || !array->get(1)->is_string())
    section.wrong(key, text::described(*node), allowed);
  const Edge edge{point(section, key, section.text_of(*array->get(1), key)),
                  point(section, key, section.text_of(*array->get(0), key))};
  if (edge.to == edge.from)
    section.wrong(key, "from '" + to_.entities[edge.to].name + "' to itself", allowed);
  return edge;
}

std::pair<Edge, Edge> Reader::two_edges(Section& section, const std::string& key) const {
  const std::string allowed = "two edges, each the name of a vector or an array of two points";
  const toml::node* node = section.node(key);
  if (!node) section.missing(key, allowed);
  const toml::array* array = node->as_array();
  if (!array || array->size() != 2) section.wrong(key, text::described(*node), allowed);
  return {edge(section, key, array->get(0)), edge(section, key, array->get(1))};
}

Coordinate Reader::coordinate(const Section& section, const std::string& key, const std::string& text) const {
  const auto dot = text.rfind('.');
  if (dot == std::string::npos) return {-1, 0, find(relatives_, section, key, "angle or length", text)};
  const int e = find(entities_, section, key, "point or vector", text.substr(0, dot));
  const std::string axis = text.substr(dot + 1);
  const auto found = std::string("xyz").substr(0, static_cast<std::size_t>(to_.dimension)).find(axis);
  if (axis.size() != 1 || found == std::string::npos)
    section.wrong(key, "the axis '" + axis + "'", to_.dimension == 2 ? "x or y" : "x, y or z");
  return {e, static_cast<int>(found)};
}

Coordinate Reader::required_coordinate(Section& section, const std::string& key) const {
  return coordinate(section, key, section.required_text(key));
}

Description read_mechanism(const std::filesystem::path& file, const ElementKinds& kinds,
                           const ParameterValues& parameters) {
  return read_mechanism(text::Document(file), kinds, parameters);
}

Description read_mechanism(const std::string& name, const std::string& text, const ElementKinds& kinds,
                           const ParameterValues& parameters) {
  return read_mechanism(text::Document(name, text), kinds, parameters);
}

Description read_mechanism(const text::Document& document, const ElementKinds& kinds,
                           const ParameterValues& parameters) {
  return Reader(document, kinds, parameters).read();
}

}  // namespace tandem::mbs
