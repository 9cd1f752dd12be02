// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include "tandem/fmi/description.hpp"

namespace tandem::ssp {

/// Of an element [characters].
inline constexpr std::size_t longest_name = 1000;

/// An attribute of tandem's own annotation, as a text that --set would take.
using Settings = std::map<std::string, std::string>;

struct Connector {
  std::string kind, unit;  ///< unit: as tandem writes it; empty: not said
};

/// What an FMU says of itself, and its variables by name.
struct Fmu {
  explicit Fmu(fmi::Description of) : description(std::move(of)) {
    for (const fmi::Variable& v : description.variables) variables.emplace(v.name, &v);
  }
  Fmu(const Fmu&) = delete;
  Fmu& operator=(const Fmu&) = delete;

  fmi::Description description;
  std::unordered_map<std::string_view, const fmi::Variable*> variables = {};
};

/// A system, or a component that is an FMU.
struct Element {
  std::string name;
  int parent = -1;  ///< the system that it is in
  int line = 0;     ///< of the outermost description
  std::map<std::string, Connector> connectors = {};
  std::filesystem::path file = {};
  std::string implementation = {};      ///< "any", "CoSimulation", "ModelExchange"
  std::shared_ptr<const Fmu> fmu = {};  ///< null: a system
  Settings settings = {};

  bool is_system() const { return !fmu; }
};

/// A connector of an element.
using Node = std::pair<int, std::string>;

/// What a value becomes: to the unit of where it goes, then factor * value + offset.
struct Transformation {
  double factor = 1.0, offset = 0.0;
  bool keeps_number = false;  ///< whatever the units are
};

/// One connection, in the direction in which values go.
struct Edge {
  Node from, to;
  Transformation how = {};
  int line = 0;
  Settings settings = {};
};

/// An item of an enumeration: its name, and its number if the file defines it.
struct Item {
  std::string name;
  std::optional<double> number;
};
/// What is no number, text, boolean or item.
struct Unreadable {};

/// A value before the start. Of an array several numbers.
struct Given {
  std::variant<double, bool, std::string, std::vector<double>, Item, Unreadable> value;
  std::string unit = {};    ///< empty: not said
  Transformation how = {};  ///< of a mapping
  int line = 0;
  std::size_t order = 0;  ///< of two for one variable the later holds
};

/// A system as it is written, nested ones in it.
struct Structure {
  std::filesystem::path file;
  std::string name, description;
  std::optional<double> start, stop;  ///< [s]
  std::vector<Element> elements;      ///< the outermost system first, each before what is in it
  std::map<std::pair<int, std::string>, int> numbers;  ///< of elements, by parent and name
  std::vector<Edge> edges;                             ///< in the order of the file
  std::map<Node, std::size_t> into;                    ///< of edges, by where they go
  std::map<Node, Given> given;
  std::size_t values = 0;  ///< that were given, by all bindings
  std::size_t parts = 0;   ///< all that has been read, which is bounded
  Settings settings;
  std::vector<std::string> remarks;
  std::set<std::string> unknown_units;    ///< of values that are taken as they are
  std::set<std::string> undefined_units;  ///< of connectors whose FMU says another

  /// Notes one more part. Throws Error, which names a line, for too many.
  void count(int line);
  const Element& at(int element) const { return elements[static_cast<std::size_t>(element)]; }
  /// "motor.shaft.w", of elements from the outermost inwards.
  std::string full_name(int element) const;
  /// Null: the element, a component, has no such variable.
  const fmi::Variable* variable(const Node& node) const;
  /// As tandem writes it: of the connector, else of the FMU; empty: not said.
  std::string unit(const Node& node) const;
};

/// Reads a system.
Structure read_structure(const std::filesystem::path& file);

}  // namespace tandem::ssp
