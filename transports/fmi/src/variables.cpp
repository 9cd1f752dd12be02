// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "variables.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_set>

#include "tandem/printable.hpp"

namespace tandem::fmi {
namespace {

const std::map<std::string, Type> types = {{"Real", Type::real},
                                           {"Integer", Type::integer},
                                           {"Boolean", Type::boolean},
                                           {"Enumeration", Type::enumeration},
                                           {"String", Type::string}};
const std::map<std::string, Causality> causalities = {
    {"parameter", Causality::parameter}, {"calculatedParameter", Causality::calculated_parameter},
    {"input", Causality::input},         {"output", Causality::output},
    {"local", Causality::local},         {"independent", Causality::independent}};
const std::map<std::string, Variability> variabilities = {{"constant", Variability::constant},
                                                          {"fixed", Variability::fixed},
                                                          {"tunable", Variability::tunable},
                                                          {"discrete", Variability::discrete},
                                                          {"continuous", Variability::continuous}};

class VariableReader {
 public:
  VariableReader(const Xml& xml, pugi::xml_node root) : xml_(xml) {
    for (const pugi::xml_node type : root.child("TypeDefinitions").children("SimpleType"))
      declared_[xml.needed_text(type, "name")] = type.first_child();
  }

  std::vector<Variable> read(pugi::xml_node list) {
    std::vector<Variable> all;
    for (const pugi::xml_node node : list.children("ScalarVariable")) {
      all.push_back(variable(node));
      if (!names_.insert(all.back().name).second)
        xml_.refuse(node, "variable '" + printable(all.back().name, 200) + "' is there twice");
    }
    read_derivatives(list, all);
    return all;
  }

 private:
  Variable variable(pugi::xml_node node) const {
    Variable v;
    v.name = xml_.needed_text(node, "name");
    v.description = xml_.text(node, "description").value_or("");
    const auto reference = xml_.whole(node, "valueReference", 0, std::numeric_limits<std::uint32_t>::max());
    if (!reference) xml_.wrong(node, "valueReference", "a whole number from 0");
    v.reference = static_cast<std::uint32_t>(*reference);
    v.causality = xml_.word(node, "causality", causalities, Causality::local);
    const pugi::xml_node type = type_node(node);
    v.type = types.at(type.name());
    const auto usual = v.type == Type::real ? Variability::continuous : Variability::discrete;
    v.variability = xml_.word(node, "variability", variabilities, usual);
    v.start = xml_.text(type, "start");
    read_type(type, v);
    return v;
  }

  pugi::xml_node type_node(pugi::xml_node variable) const {
    for (const pugi::xml_node child : variable.children())
      if (types.count(child.name()) != 0) return child;
    xml_.refuse(variable,
                "variable '" + printable(variable.attribute("name").value(), 200) +
                    "' has no type; allowed are <Real>, <Integer>, <Boolean>, <String>, <Enumeration>");
  }

  /// What the variable does not say its declared type may.
  void read_type(pugi::xml_node type, Variable& v) const {
    const auto name = xml_.text(type, "declaredType");
    const auto found = name ? declared_.find(*name) : declared_.end();
    if (name && found == declared_.end()) xml_.wrong(type, "declaredType", "the name of a <SimpleType>");
    const pugi::xml_node declared = name ? found->second : pugi::xml_node();
    const auto number = [&](const char* attribute, double otherwise) {
      const auto own = xml_.number(type, attribute);
      return (own ? own : xml_.number(declared, attribute)).value_or(otherwise);
    };
    v.min = number("min", v.type == Type::boolean ? 0.0 : v.min);
    v.max = number("max", v.type == Type::boolean ? 1.0 : v.max);
    read_start(type, v);
    if (v.type == Type::enumeration) read_items(declared, v);
    if (v.type != Type::real) return;
    const auto unit = xml_.text(type, "unit");
    v.unit = unit_of_fmi((unit ? unit : xml_.text(declared, "unit")).value_or(""));
    v.nominal = std::abs(number("nominal", 1.0));
    if (!(v.nominal > 0.0) || !std::isfinite(v.nominal)) xml_.wrong(type, "nominal", "a number other than 0");
  }

  void read_start(pugi::xml_node type, Variable& v) const {
    if (!v.start || v.type == Type::string) return;
    v.start_value =
        v.type == Type::boolean ? (xml_.flag(type, "start") ? 1.0 : 0.0) : *xml_.number(type, "start");
  }

  void read_items(pugi::xml_node declared, Variable& v) const {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const pugi::xml_node item : declared.children("Item"))
      if (const auto value = xml_.number(item, "value"))
        least = std::min(least, *value), most = std::max(most, *value);
    if (least > most) return;
    v.min = std::max(v.min, least), v.max = std::min(v.max, most);
  }

  /// They name variables that may come later.
  void read_derivatives(pugi::xml_node list, std::vector<Variable>& all) const {
    std::size_t k = 0;
    for (const pugi::xml_node node : list.children("ScalarVariable")) {
      const auto of = xml_.whole(node.child("Real"), "derivative", 1, std::ssize(all));
      if (of) all[k].derivative_of = static_cast<int>(*of) - 1;
      ++k;
    }
  }

  const Xml& xml_;
  std::map<std::string, pugi::xml_node> declared_;
  std::unordered_set<std::string> names_;
};

}  // namespace

std::vector<Variable> read_variables(const Xml& xml, pugi::xml_node root) {
  return VariableReader(xml, root).read(root.child("ModelVariables"));
}

}  // namespace tandem::fmi
