// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "connected.hpp"
#include "document.hpp"
#include "structure.hpp"
#include "tandem/coordinator/units.hpp"
#include "tandem/error.hpp"
#include "tandem/fmi/archive.hpp"
#include "tandem/nearest.hpp"
#include "tandem/printable.hpp"
#include "tandem/text/place.hpp"

namespace tandem::ssp {
namespace {

namespace fs = std::filesystem;
using fmi::children;

constexpr int deepest = 32;
constexpr const char* description_element = "SystemStructureDescription";

class StructureReader {
 public:
  explicit StructureReader(const fs::path& file) { to_.file = file; }

  Structure read() {
    const bool is_archive = to_.file.extension() == ".ssp";
    const Document& document =
        documents_.open(is_archive ? description_in(to_.file) : to_.file, description_element);
    const fmi::Xml& xml = document.xml;
    to_.name = xml.needed_text(document.root, "name");
    to_.description = xml.text(document.root, "description").value_or("");
    const xml_node experiment = xml.only(document.root, "DefaultExperiment");
    to_.start = xml.number(experiment, "startTime"), to_.stop = xml.number(experiment, "stopTime");
    to_.settings = own_annotation(document, document.root);
    read_system(document, system_of(document), add({"", -1, xml.line(document.root)}));
    if (fmus_.empty()) xml.refuse(document.root, "the system has no component; allowed are one and more");
    return std::move(to_);
  }

 private:
  static xml_node system_of(const Document& document) {
    const xml_node system = document.xml.only(document.root, "System");
    if (!system) document.xml.refuse(document.root, "the description has no System");
    return system;
  }

  int add(Element element) {
    to_.count(element.line);
    const auto number = static_cast<int>(to_.elements.size());
    to_.numbers[{element.parent, element.name}] = number;
    to_.elements.push_back(std::move(element));
    return number;
  }

  /// Of the outermost description, whatever it is that refers to others.
  int line(const Document& document, xml_node of) const { return line_ != 0 ? line_ : document.xml.line(of); }

  void read_system(const Document& document, xml_node system, int number) {
    if (++depth_ > deepest)
      document.xml.refuse(system, fmt::format("more than {} systems lie in each other", deepest));
    refuse_annotation(document, system);
    read_connectors(document, system, number);
    for (const xml_node one : document.xml.only(system, "Elements")) read_element(document, one, number);
    for (const xml_node one : children(document.xml.only(system, "Connections"), "Connection"))
      add_connection(document, one, line(document, one), number, to_);
    apply_bindings(document, system, line_, number, to_);
    --depth_;
  }

  static void refuse_annotation(const Document& document, xml_node of) {
    if (!own_annotation(document, of).empty())
      document.xml.refuse(of,
                          "a system has an annotation org.tandem.coordination; allowed is one of the "
                          "outermost description, of components that are FMUs, and of connections");
  }

  void read_connectors(const Document& document, xml_node of, int number) {
    for (const xml_node one : children(document.xml.only(of, "Connectors"), "Connector")) {
      to_.count(line(document, one));
      const std::string name = document.xml.needed_text(one, "name");
      const Connector connector{kind(document, one), unit(document, type_of(one), {number, name})};
      if (!to_.elements[static_cast<std::size_t>(number)].connectors.try_emplace(name, connector).second)
        document.xml.refuse(one, "connector '" + printable(name, 200) + "' is there twice");
    }
  }

  static std::string one_of(const Document& document, xml_node of, const char* attribute,
                            const std::vector<std::string>& known, const std::string& otherwise) {
    const std::string found = document.xml.text(of, attribute).value_or(otherwise);
    if (std::find(known.begin(), known.end(), found) == known.end())
      document.xml.wrong(of, attribute, listed(known));
    return found;
  }

  static std::string kind(const Document& document, xml_node connector) {
    return one_of(
        document, connector, "kind",
        {"input", "output", "parameter", "calculatedParameter", "structuralParameter", "constant", "local"},
        "");
  }

  /// A name that the file does not define and that means nothing here may mean something in the FMU.
  std::string unit(const Document& document, xml_node type, const Node& node) {
    const std::string name = document.xml.text(type, "unit").value_or("");
    const fmi::Variable* v = to_.at(node.first).is_system() ? nullptr : to_.variable(node);
    const std::string unit = fmi::unit_in(name, document.defined.units);
    const bool of_fmu = document.defined.units.count(name) == 0 && !base_unit(unit) && v && !v->unit.empty();
    if (of_fmu && !name.empty()) to_.undefined_units.insert(printable(name, 100));
    return of_fmu ? "" : unit;
  }

  void read_element(const Document& document, xml_node one, int parent) {
    const std::string_view kind = fmi::local_name(one);
    Element element{document.xml.needed_text(one, "name"), parent, line(document, one)};
    if (element.name.size() > longest_name)
      document.xml.refuse(one, fmt::format("an element has a name of {} characters; allowed are at most {}",
                                           element.name.size(), longest_name));
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
    if (type == nested[0] || type == nested[1])
      return read_nested(document, one, std::move(element), type == nested[1]);
    if (type != fmu) document.xml.wrong(one, "type", fmt::format("{}, {}, {}", fmu, nested[0], nested[1]));
    element.file = document.beside(one, "source");
    element.implementation =
        one_of(document, one, "implementation", {"any", "CoSimulation", "ModelExchange"}, "any");
    element.settings = own_annotation(document, one);
    element.fmu = fmu_at(document, one, element.file);
    const int number = add(std::move(element));
    read_connectors(document, one, number);
    apply_bindings(document, one, line_, number, to_);
  }

  std::shared_ptr<const Fmu> fmu_at(const Document& document, xml_node of, const fs::path& file) {
    auto& known = fmus_[file];
    if (!known) try {
        known = std::make_shared<const Fmu>(fmi::description_of(fmi::Archive(file), file));
      } catch (const Error& error) {
        document.xml.refuse(of, error.what());
      }
    return known;
  }

  /// Its own bindings come after those of its system, so they hold.
  void read_nested(const Document& document, xml_node one, Element element, bool is_archive) {
    const fs::path source = document.beside(one, "source");
    const fs::path file = is_archive ? description_in(source) : source;
    if (!open_.insert(file).second)
      document.xml.refuse(one, "'" + printable(file.string(), 200) + "' holds itself");
    refuse_annotation(document, one);
    const int outside = line_;
    line_ = element.line;
    const int number = add(std::move(element));
    const Document& inside = documents_.open(file, description_element);
    refuse_annotation(inside, inside.root);
    read_system(inside, system_of(inside), number);
    apply_bindings(document, one, line_, number, to_);
    line_ = outside;
    open_.erase(file);
  }

  Structure to_;
  int line_ = 0;  ///< of the component of the outermost description that is being read; 0: it is no other one
  std::set<fs::path> open_;
  int depth_ = 0;  ///< of the system that is being read
  Documents documents_;
  std::map<fs::path, std::shared_ptr<const Fmu>> fmus_;
};

}  // namespace

void Structure::count(int line) {
  constexpr std::size_t most = std::size_t{1} << 17;
  if (++parts > most)
    text::refuse(
        {file.string(), line},
        fmt::format("the system has more than {} elements, connectors, connections and values", most));
}

std::string Structure::full_name(int element) const {
  const Element& at = this->at(element);
  return at.parent > 0 ? full_name(at.parent) + "." + at.name : at.name;
}

const fmi::Variable* Structure::variable(const Node& node) const {
  const auto& all = at(node.first).fmu->variables;
  const auto it = all.find(node.second);
  return it == all.end() ? nullptr : it->second;
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
