// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "tandem/mbs/mechanism/body_mass.hpp"
#include "tandem/nearest.hpp"
#include "tandem/text/section.hpp"

namespace tandem::mbs {
namespace {

using text::Document;
using text::refuse;
using text::Section;

/// Fills a Description, table by table.
class Reader {
 public:
  explicit Reader(const Document& document) : document_(document) {}

  Description read() {
    Section root(document_, document_.table(), "");
    to_.name = root.text("name").value_or(document_.file());
    root.text("description");
    read_dimension(root);
    to_.gravity = vector(root, "gravity").value_or(Eigen::Vector3d::Zero());
    each(root, "points",
         [&](const std::string& name, Section s) { read_entity(name, s, Entity::Kind::point); });
    each(root, "vectors",
         [&](const std::string& name, Section s) { read_entity(name, s, Entity::Kind::vector); });
    each(root, "rods", [&](const std::string& name, Section s) { read_rod(name, s); });
    each(root, "bodies", [&](const std::string& name, Section s) { read_body(name, s); });
    each(root, "distances", [&](const std::string& name, Section s) { read_distance(name, s); });
    root.refuse_unknown();
    if (to_.bodies.empty()) root.missing("rods", "a table [rods.NAME] or [bodies.NAME] for each body");
    return std::move(to_);
  }

 private:
  void read_dimension(Section& root) {
    const auto dimension = root.number("dimension");
    if (!dimension) root.missing("dimension", "2 for the plane, 3 for space");
    if (*dimension != 2.0 && *dimension != 3.0)
      root.wrong("dimension", fmt::format("{}", *dimension), "2 for the plane, 3 for space");
    to_.dimension = static_cast<int>(*dimension);
  }

  /// Calls read(name, section) for each table below a key, in the order of the file.
  template <class Read>
  void each(Section& root, const std::string& key, const Read& read) {
    const toml::table* table = root.table(key);
    if (!table) return;
    for (const auto& [name, node] : text::in_file_order(*table)) {
      if (!node->is_table())
        refuse(document_.place(*node),
               key + "." + name + " is " + text::described(*node) + "; allowed is a table");
      Section section(document_, *node->as_table(), key + "." + name);
      read(name, section);
    }
  }

  /// An array of as many numbers as the mechanism has dimensions; the third is zero in the plane.
  std::optional<Eigen::Vector3d> vector(Section& section, const std::string& key) const {
    const toml::node* node = section.node(key);
    if (!node) return std::nullopt;
    const toml::array* array = node->as_array();
    const std::string allowed = fmt::format("an array of {} numbers", to_.dimension);
    if (!array || static_cast<int>(array->size()) != to_.dimension)
      section.wrong(key, array ? fmt::format("an array of {}", array->size()) : text::described(*node),
                    allowed);
    Eigen::Vector3d value = Eigen::Vector3d::Zero();
    for (int i = 0; i < to_.dimension; ++i)
      value[i] = text::number_of(document_, *array->get(i), fmt::format("{}[{}]", section.name(key), i));
    return value;
  }

  void read_entity(const std::string& name, Section& section, Entity::Kind kind) {
    Entity entity{name, kind};
    const auto at = vector(section, "at");
    if (!at) section.missing("at", fmt::format("its {} coordinates as drawn [m]", to_.dimension));
    entity.at = *at;
    entity.fixed = section.flag("fixed").value_or(false);
    entity.velocity = vector(section, "velocity").value_or(Eigen::Vector3d::Zero());
    if (entity.fixed && entity.velocity.norm() > 0.0)
      section.wrong("velocity", "not zero", "zero, as the point is fixed");
    section.refuse_unknown();
    if (!numbers_.emplace(name, static_cast<int>(to_.entities.size())).second)
      refuse(section.place(), "'" + name + "' names a point and a vector; allowed is a name of its own");
    to_.entities.push_back(entity);
  }

  int entity(const Section& section, const std::string& key, const std::string& name) const {
    const auto it = numbers_.find(name);
    if (it != numbers_.end()) return it->second;
    std::vector<std::string> known;
    for (const Entity& e : to_.entities) known.push_back(e.name);
    refuse(section.place(key), section.name(key) + ": " + unknown("point", name, known));
  }

  /// The two points of a key.
  std::pair<int, int> two_points(Section& section, const std::string& key) {
    const auto names = section.texts(key);
    if (names.empty()) section.missing(key, "the names of two points");
    if (names.size() != 2)
      section.wrong(key, fmt::format("{} names", names.size()), "the names of two points");
    const int a = entity(section, key, names[0]), b = entity(section, key, names[1]);
    for (const int e : {a, b})
      if (to_.entities[e].kind != Entity::Kind::point)
        section.wrong(key, "the vector '" + to_.entities[e].name + "'", "the names of two points");
    if (a == b) section.wrong(key, "'" + names[0] + "' twice", "the names of two points");
    return {a, b};
  }

  double length(Section& section, const std::string& key, const std::pair<int, int>& points) {
    const double drawn = (to_.entities[points.second].at - to_.entities[points.first].at).norm();
    if (!(drawn > 0.0))
      refuse(section.place(key),
             section.name(key) + " are drawn at one place; allowed is a distance above 0 m");
    return drawn;
  }

  double mass(Section& section) {
    const auto value = section.positive("mass");
    if (!value) section.missing("mass", "a number above 0 [kg]");
    return *value;
  }

  void read_rod(const std::string& name, Section& section) {
    const auto points = two_points(section, "points");
    length(section, "points", points);
    to_.bodies.push_back(uniform_rod(to_, name, points.first, points.second, mass(section)));
    section.refuse_unknown();
  }

  void read_body(const std::string& name, Section& section) {
    Body body{name, {}};
    for (const std::string& entity_name : section.texts("points"))
      body.entities.push_back(entity(section, "points", entity_name));
    for (const std::string& entity_name : section.texts("vectors"))
      body.entities.push_back(entity(section, "vectors", entity_name));
    body.mass = mass(section);
    const auto centre = vector(section, "centre");
    if (!centre) section.missing("centre", "the centre of mass as drawn [m]");
    body.centre = *centre;
    body.inertia = inertia(section);
    section.refuse_unknown();
    text::located(section.place(), [&] { body_mass(to_, body); });
    to_.bodies.push_back(std::move(body));
  }

  /// In the plane a number; in space three rows of three.
  Eigen::Matrix3d inertia(Section& section) {
    Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
    if (to_.dimension == 2) {
      const auto polar = section.positive("inertia");
      if (!polar) section.missing("inertia", "a number above 0 [kg m^2]");
      tensor(2, 2) = *polar;
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

  void read_distance(const std::string& name, Section& section) {
    const auto points = two_points(section, "points");
    const double l = section.positive("length").value_or(length(section, "points", points));
    const Edge edge{points.second, points.first};
    to_.products.push_back({name, edge, edge, l * l});
    section.refuse_unknown();
  }

  const Document& document_;
  Description to_;
  std::map<std::string, int> numbers_;
};

}  // namespace

Description read_mechanism(const std::filesystem::path& file) {
  const Document document(file);
  return Reader(document).read();
}

Description read_mechanism(const std::string& name, const std::string& text) {
  const Document document(name, text);
  return Reader(document).read();
}

}  // namespace tandem::mbs
