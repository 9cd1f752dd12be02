// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "connected.hpp"
#include "tandem/nearest.hpp"
#include "tandem/printable.hpp"
#include "values.hpp"

namespace tandem::ssp {
namespace {

class ConnectionReader {
 public:
  ConnectionReader(const Document& document, xml_node connection, int system, const Structure& of)
      : xml_(document.xml), node_(connection), system_(system), of_(of) {}

  /// Start and end say nothing of where values go: the kinds of the connectors do.
  std::pair<Node, Node> ends() const {
    Node from = end("startElement", "startConnector"), to = end("endElement", "endConnector");
    const bool starts = gives(from);
    if (starts == gives(to))
      xml_.refuse(node_,
                  fmt::format("both ends of the connection, '{}' and '{}', {} values; allowed is that one "
                              "gives and the other takes them",
                              shown(from), shown(to), starts ? "give" : "take"));
    if (!starts) std::swap(from, to);
    if (is_parameter(to) && !is_constant(from))
      xml_.refuse(node_, "parameter '" + shown(to) + "' is to follow '" + shown(from) +
                             "', which changes; allowed are parameters and calculated ones");
    if (of_.into.count(to) != 0)
      xml_.refuse(node_, "'" + shown(to) + "' takes values of a second connection; allowed is one");
    return {std::move(from), std::move(to)};
  }

 private:
  std::string shown(const Node& node) const {
    const std::string element = node.first == system_ ? "" : of_.at(node.first).name + ".";
    return printable(element + node.second, 200);
  }

  Node end(const char* element, const char* connector) const {
    const std::string name = xml_.text(node_, element).value_or("");
    Node node{name.empty() ? system_ : number(name), xml_.needed_text(node_, connector)};
    check(node);
    return node;
  }

  int number(const std::string& name) const {
    const auto it = of_.numbers.find({system_, name});
    if (it != of_.numbers.end()) return it->second;
    std::vector<std::string> known;
    for (const Element& element : of_.elements)
      if (element.parent == system_) known.push_back(element.name);
    xml_.refuse(node_, unknown("element", printable(name, 200), known));
  }

  void check(const Node& node) const {
    const Element& at = of_.at(node.first);
    if (at.is_system() ? at.connectors.count(node.second) != 0 : of_.variable(node) != nullptr) return;
    std::vector<std::string> known;
    for (const auto& [name, connector] : at.connectors)
      if (at.is_system() || of_.variable({node.first, name})) known.push_back(name);
    if (!at.is_system() && known.empty())
      for (const fmi::Variable& v : at.fmu->description.variables) known.push_back(v.name);
    xml_.refuse(node_, "'" + printable(at.name, 200) +
                           "': " + unknown("connector", printable(node.second, 200), known));
  }

  std::string kind(const Node& node) const {
    const Element& at = of_.at(node.first);
    return at.is_system() ? at.connectors.at(node.second).kind : "";
  }
  /// Of a system.
  bool is_parameter(const Node& node) const {
    return kind(node) == "parameter" || kind(node) == "structuralParameter";
  }
  bool is_constant(const Node& node) const {
    if (of_.at(node.first).is_system())
      return is_parameter(node) || kind(node) == "calculatedParameter" || kind(node) == "constant";
    const fmi::Variability v = of_.variable(node)->variability;
    return v != fmi::Variability::discrete && v != fmi::Variability::continuous;
  }

  bool gives(const Node& node) const {
    const Element& at = of_.at(node.first);
    if (at.is_system()) {
      const bool inwards = is_parameter(node) || kind(node) == "input";
      return inwards == (node.first == system_);
    }
    using enum fmi::Causality;
    const fmi::Causality causality = of_.variable(node)->causality;
    return causality != input && causality != parameter && causality != structural_parameter;
  }

  const fmi::Xml& xml_;
  xml_node node_;
  int system_;
  const Structure& of_;
};

}  // namespace

void add_connection(const Document& document, xml_node connection, int line, int system, Structure& to) {
  if (connection.attribute("startIndices") || connection.attribute("endIndices"))
    document.xml.refuse(connection, "elements of arrays can't be connected; allowed are whole arrays");
  to.count(line);
  auto [from, into] = ConnectionReader(document, connection, system, to).ends();
  to.into[into] = to.edges.size();
  to.edges.push_back({std::move(from), std::move(into), read_transformation(document, connection), line,
                      own_annotation(document, connection)});
}

}  // namespace tandem::ssp
