// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mechanism/elements/own_elements.hpp"
#include "tandem/mbs/mechanism/keys.hpp"
#include "tandem/mbs/mechanism/motions.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/text/file_parameters.hpp"

namespace tandem::mbs {

/// Fills a Description, table by table. What one table names stands in a table read before it.
class Reader {
 public:
  /// document and given must outlive it. kinds: of elements, besides the own ones.
  Reader(const text::Document& document, const ElementKinds& kinds, const ParameterValues& given)
      : document_(document),
        folder_(std::filesystem::path(document.file()).parent_path()),
        language_(mechanism_keys(kinds)),
        kinds_(own_elements()),
        given_(given) {
    kinds_.insert(kinds.begin(), kinds.end());
  }
  Description read();

 private:
  using Section = text::Section;
  using Names = std::map<std::string, int>;  ///< index by name

  // read.cpp: the root, and what the others read by
  void read_name(Section& root);
  void read_dimension(Section& root);
  template <class Read>
  void each(Section& root, const std::string& key, const Read& read);
  Eigen::Vector3d vector(Section& section, const std::string& key) const;  ///< zero if it is not there
  Eigen::Vector3d required_vector(Section& section, const std::string& key) const;
  /// A number or an array of numbers; empty if it is not there.
  std::vector<double> numbers(Section& section, const std::string& key) const;
  /// A name of an angle, length or free coordinate; of what belongs to a point a dot tells.
  void relative_name(const Section& section, const std::string& name);
  /// Refuses a name that is there twice.
  void name(Names& names, const Section& section, const std::string& name, std::size_t index) const;
  int find(const Names& names, const Section& section, const std::string& key, const std::string& kind,
           const std::string& name) const;
  /// Refuses a name that a port can't have.
  void port_name(const Section& section, const std::string& name) const;
  int point(Section& section, const std::string& key, const std::string& name) const;
  /// The number of a vector that is named; `allowed` is told where it is none.
  int vector_named(Section& section, const std::string& key, const std::string& name,
                   const std::string& allowed) const;
  /// The two points of a key, apart from each other as drawn.
  Edge two_points(Section& section, const std::string& key) const;
  /// A vector's name, or an array of two points.
  Edge edge(Section& section, const std::string& key, const toml::node* node) const;
  std::pair<Edge, Edge> two_edges(Section& section, const std::string& key) const;
  /// Exactly one of the keys is to be there; `owner` is "force 'f'".
  void only_one(Section& section, const std::string& owner, const std::vector<std::string>& keys) const;
  /// "P.x" or the name of a relative coordinate.
  Coordinate coordinate(const Section& section, const std::string& key, const std::string& text) const;
  Coordinate required_coordinate(Section& section, const std::string& key) const;

  // bodies.cpp
  void read_entity(const std::string& name, Section& section, Entity::Kind kind);
  void read_rod(const std::string& name, Section& section);
  void read_body(const std::string& name, Section& section);
  void read_mass(const std::string& name, Section& section);
  void add_entity(Section& section, const std::string& key, int entity, Body& body) const;
  Eigen::Matrix3d inertia(Section& section) const;

  // constraints.cpp
  void read_distance(const std::string& name, Section& section);
  void read_product(const std::string& name, Section& section);
  void read_fixed_angle(const std::string& name, Section& section);
  void read_joint(const std::string& name, Section& section);
  void read_axes(Section& section, Joint& joint) const;
  Carrier carrier(Section& section, const std::string& name) const;
  void read_angle(const std::string& name, Section& section);
  void read_length(const std::string& name, Section& section);
  void read_drive(const std::string& name, Section& section);

  // coordinates.cpp
  void read_coordinate(const std::string& name, Section& section);
  void read_relation(const std::string& name, Section& section);
  void read_products(Section& section, Relation& relation) const;
  void read_slide(const std::string& name, Section& section);
  /// Of a length or a distance: keys between and ends.
  Ends ends(Section& section) const;
  Carrier length_carrier(Section& section, const toml::node& node) const;
  int relative(Section& section, const std::string& key) const;

  // forces.cpp
  void read_input(const std::string& name, Section& section);
  void read_function(Section& section, Input& input) const;
  static Sine sine_of(Section section);
  void read_spring(const std::string& name, Section& section);
  void read_force(const std::string& name, Section& section);
  /// An input's name, or a number, which becomes an input of its own.
  int magnitude(Section& section, const std::string& name);
  /// Refuses an input whose unit is not one of those that its use allows.
  void unit(Section& section, const std::string& key, int input,
            const std::vector<std::string>& allowed) const;
  void refuse_unused_inputs(Section& root) const;

  // elements.cpp
  class Keys;
  void read_element(const std::string& name, Section& section);

  // outputs.cpp
  void read_output(const std::string& name, Section& section);
  void read_element_quantity(Section& section, const std::string& element, Output& output) const;
  void read_reaction(Section& section, const std::string& of, Output& output) const;
  void read_body_of_reaction(Section& section, const std::string& name, Output& output) const;
  void read_accelerance(Section& section, Output& output) const;
  void check_column(const Section& section, const Output& output) const;
  void read_initial(Section& root);
  void read_given(Section& initial, const std::string& key, std::vector<Given>& to);

  // limits.cpp
  void read_limit(const std::string& name, Section& section);
  Output signal(Section& section) const;

  const text::Document& document_;
  std::filesystem::path folder_;
  Description to_;
  text::Keys language_;
  ElementKinds kinds_;
  const ParameterValues& given_;
  text::Values values_;
  Names entities_, bodies_, relatives_, inputs_, drives_, elements_;
};

}  // namespace tandem::mbs
