// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "connected.hpp"
#include "document.hpp"
#include "structure.hpp"
#include "tandem/error.hpp"
#include "tandem/fmi/archive.hpp"
#include "tandem/nearest.hpp"
#include "tandem/printable.hpp"

namespace tandem::ssp {
namespace {

namespace fs = std::filesystem;
using fmi::child;
using fmi::children;

constexpr int deepest = 32;
constexpr const char* description_element = "SystemStructureDescription";

class StructureReader {
 public:
  explicit StructureReader(const fs::path& file) { to_.file = file; }

  Structure read() {
    const Document document(description_in(to_.file), description_element);
    const fmi::Xml& xml = document.xml;
    to_.name = xml.needed_text(document.root, "name");
    to_.description = xml.text(document.root, "description").value_or("");
    const xml_node experiment = child(document.root, "DefaultExperiment");
    to_.start = xml.number(experiment, "startTime"), to_.stop = xml.number(experiment, "stopTime");
    to_.settings = own_annotation(document, document.root);
    read_system(document, system_of(document), add({"", -1, xml.line(document.root)}));
    if (descriptions_.empty())
      xml.refuse(document.root, "the system has no component; allowed are one and more");
    return std::move(to_);
  }

 private:
  static xml_node system_of(const Document& document) {
    const xml_node system = child(document.root, "System");
    if (!system) document.xml.refuse(document.root, "the description has no System");
    return system;
  }

  int add(Element element) {
    constexpr std::size_t most = 65536;
    if (to_.elements.size() == most)
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("{}:{}: more than {} elements", to_.file.string(), element.line, most));
    const auto number = static_cast<int>(to_.elements.size());
    to_.numbers[{element.parent, element.name}] = number;
    to_.elements.push_back(std::move(element));
    return number;
  }

  /// Of the outermost description, whatever it is that refers to others.
  int line(const Document& document, xml_node of) const { return line_ != 0 ? line_ : document.xml.line(of); }

  void read_system(const Document& document, xml_node system, int number) {
    read_connectors(document, system, number);
    for (const xml_node one : child(system, "Elements")) read_element(document, one, number);
    for (const xml_node one : children(child(system, "Connections"), "Connection"))
      add_connection(document, one, line(document, one), number, to_);
    apply_bindings(document, system, line_, number, to_);
  }

  void read_connectors(const Document& document, xml_node of, int number) {
    for (const xml_node one : children(child(of, "Connectors"), "Connector")) {
      const std::string unit = document.xml.text(one.first_child(), "unit").value_or("");
      const Connector connector{document.xml.text(one, "kind").value_or(""),
                                fmi::unit_in(unit, document.defined.units)};
      auto& all = to_.elements[static_cast<std::size_t>(number)].connectors;
      if (!all.try_emplace(document.xml.needed_text(one, "name"), connector).second)
        document.xml.refuse(
            one, "connector '" + printable(one.attribute("name").value(), 200) + "' is there twice");
    }
  }

  void read_element(const Document& document, xml_node one, int parent) {
    const std::string_view kind = fmi::local_name(one);
    Element element{document.xml.needed_text(one, "name"), parent, line(document, one)};
    if (to_.numbers.count({parent, element.name}) != 0)
      document.xml.refuse(one, "element '" + printable(element.name, 200) + "' is there twice");
    if (kind == "System") return read_system(document, one, add(std::move(element)));
    if (kind != "Component")
      document.xml.refuse(one, "element '" + printable(element.name, 200) + "' is a <" +
                                   printable(one.name(), 100) + ">; allowed are Component and System");
    read_component(document, one, std::move(element));
  }

  void read_component(const Document& document, xml_node one, Element element) {
    constexpr const char* fmu = "application/x-fmu-sharedlibrary";
    constexpr const char* nested[] = {"application/x-ssp-definition", "application/x-ssp-package"};
    const std::string type = document.xml.text(one, "type").value_or(fmu);
    if (type == nested[0] || type == nested[1]) return read_nested(document, one, std::move(element));
    if (type != fmu) document.xml.wrong(one, "type", fmt::format("{}, {}, {}", fmu, nested[0], nested[1]));
    element.fmu = document.beside(one, "source");
    element.implementation = document.xml.text(one, "implementation").value_or("any");
    element.settings = own_annotation(document, one);
    element.description = description(document, one, element.fmu);
    const int number = add(std::move(element));
    read_connectors(document, one, number);
    apply_bindings(document, one, line_, number, to_);
  }

  std::shared_ptr<const fmi::Description> description(const Document& document, xml_node of,
                                                      const fs::path& fmu) {
    auto& known = descriptions_[fmu];
    if (!known) try {
        known = std::make_shared<const fmi::Description>(fmi::description_of(fmi::Archive(fmu), fmu));
      } catch (const Error& error) {
        document.xml.refuse(of, error.what());
      }
    return known;
  }

  /// Its own bindings come after those of its system, so they hold.
  void read_nested(const Document& document, xml_node one, Element element) {
    const fs::path file = description_in(document.beside(one, "source"));
    if (!open_.insert(file).second || static_cast<int>(open_.size()) > deepest)
      document.xml.refuse(one, fmt::format("'{}' holds itself, or more than {} systems lie in each other",
                                           printable(file.string(), 200), deepest));
    const int outside = line_;
    line_ = element.line;
    const int number = add(std::move(element));
    auto& inside = documents_[file];
    if (!inside) inside = std::make_unique<Document>(file, description_element);
    read_system(*inside, system_of(*inside), number);
    apply_bindings(document, one, line_, number, to_);
    line_ = outside;
    open_.erase(file);
  }

  Structure to_;
  int line_ = 0;  ///< of the component of the outermost description that is being read; 0: it is no other one
  std::set<fs::path> open_;
  std::map<fs::path, std::unique_ptr<Document>> documents_;  ///< of nested systems
  std::map<fs::path, std::shared_ptr<const fmi::Description>> descriptions_;
};

}  // namespace

std::string Structure::full_name(int element) const {
  const Element& at = this->at(element);
  return at.parent > 0 ? full_name(at.parent) + "." + at.name : at.name;
}

const fmi::Variable* Structure::variable(const Node& node) const {
  const auto& all = at(node.first).description->variables;
  const auto it = std::find_if(all.begin(), all.end(), [&](const auto& v) { return v.name == node.second; });
  return it == all.end() ? nullptr : &*it;
}

std::string Structure::unit(const Node& node) const {
  const Element& element = at(node.first);
  const auto it = element.connectors.find(node.second);
  if (it != element.connectors.end() && !it->second.unit.empty()) return it->second.unit;
  const fmi::Variable* v = element.is_system() ? nullptr : variable(node);
  return v ? v->unit : "";
}

Structure read_structure(const fs::path& file) { return StructureReader(file).read(); }

}  // namespace tandem::ssp
