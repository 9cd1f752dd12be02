// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "variables.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "tandem/fmi/unit_definitions.hpp"
#include "tandem/printable.hpp"
#include "words.hpp"

namespace tandem::fmi {
namespace {

class VariableReader {
 public:
  VariableReader(const Xml& xml, pugi::xml_node root, Version version)
      : xml_(xml), version_(version), types_(types_of(version)) {
    for (const pugi::xml_node type : root.child("TypeDefinitions"))
      if (const pugi::xml_attribute name = type.attribute("name"))
        declared_[name.value()] = version == Version::two ? type.first_child() : type;
    units_ = read_units(xml, root.child("UnitDefinitions"));
  }

  std::vector<Variable> read(pugi::xml_node list) {
    for (const pugi::xml_node node : list) {
      if (node.type() != pugi::node_element) continue;
      const std::size_t place = all_.size();
      add(node, variable(node));
      if (version_ == Version::three)
        for (const pugi::xml_node alias : node.children("Alias")) add_alias(node, alias, all_[place]);
    }
    for (const auto& [variable, type] : type_nodes_) read_links(type, all_[variable]);
    return std::move(all_);
  }

 private:
  void add(pugi::xml_node node, Variable v) {
    if (!names_.insert(v.name).second)
      xml_.refuse(node, "variable '" + printable(v.name, 200) + "' is there twice");
    by_reference_.try_emplace(v.reference, static_cast<int>(all_.size()));
    type_nodes_.emplace_back(all_.size(), type_node(node));
    all_.push_back(std::move(v));
  }

  /// Another name, which is no port and is not set.
  void add_alias(pugi::xml_node node, pugi::xml_node alias, const Variable& of) {
    Variable v;
    v.name = xml_.needed_text(alias, "name");
    v.reference = of.reference, v.type = of.type, v.variability = of.variability;
    v.unit = of.unit, v.nominal = of.nominal, v.min = of.min, v.max = of.max, v.clocked = of.clocked;
    add(node, std::move(v));
  }

  Variable variable(pugi::xml_node node) {
    const pugi::xml_node type = type_node(node);
    Variable v;
    v.name = xml_.needed_text(node, "name");
    v.description = xml_.text(node, "description").value_or("");
    const auto reference = xml_.whole(node, "valueReference", 0, std::numeric_limits<std::uint32_t>::max());
    if (!reference) xml_.wrong(node, "valueReference", "a whole number from 0");
    v.reference = static_cast<std::uint32_t>(*reference);
    v.causality = xml_.word(node, "causality", causalities(), Causality::local);
    v.type = types_.at(type.name());
    v.variability = xml_.word(node, "variability", variabilities(), usual_variability(v));
    v.clocked = node.attribute("clocks");
    v.intermediate = xml_.flag(node, "intermediateUpdate");
    const pugi::xml_node text = type.child("Start");  // of a text in 3.0
    v.start = text ? xml_.text(text, "value") : xml_.text(type, "start");
    read_type(type, v);
    return v;
  }

  static Variability usual_variability(const Variable& v) {
    using enum Causality;
    if (v.causality == parameter || v.causality == calculated_parameter ||
        v.causality == structural_parameter)
      return Variability::fixed;
    return is_real(v.type) ? Variability::continuous : Variability::discrete;
  }

  /// In 2.0 within the variable, in 3.0 itself.
  pugi::xml_node type_node(pugi::xml_node variable) const {
    if (types_.count(variable.name()) != 0) return variable;
    for (const pugi::xml_node child : variable.children())
      if (types_.count(child.name()) != 0) return child;
    xml_.refuse(variable, "variable '" + printable(variable.attribute("name").value(), 200) +
                              "' has no type; allowed are " + listed_types(types_));
  }

  /// What the variable does not say its declared type may.
  void read_type(pugi::xml_node type, Variable& v) {
    const auto name = xml_.text(type, "declaredType");
    const auto found = name ? declared_.find(*name) : declared_.end();
    if (name && found == declared_.end()) xml_.wrong(type, "declaredType", "the name of a type definition");
    const pugi::xml_node declared = name ? found->second : pugi::xml_node();
    const auto number = [&](const char* attribute, double otherwise) {
      const auto own = xml_.number(type, attribute);
      return (own ? own : xml_.number(declared, attribute)).value_or(otherwise);
    };
    const bool is_int = version_ == Version::two && v.type == Type::enumeration;
    const Range range = range_of(is_int ? Type::int32 : v.type);
    v.min = std::max(number("min", range.least), range.least);
    v.max = std::min(number("max", range.most), range.most);
    if (!(v.min <= v.max))
      xml_.refuse(type, "variable '" + printable(v.name, 200) + "' has a min above its max");
    read_start(type, v);
    if (v.type == Type::enumeration) read_items(declared, v);
    if (!is_real(v.type)) return;
    const auto unit = xml_.text(type, "unit");
    v.unit = unit_in((unit ? unit : xml_.text(declared, "unit")).value_or(""), units_);
    v.nominal = std::abs(number("nominal", 1.0));
    if (!(v.nominal > 0.0) || !std::isfinite(v.nominal)) xml_.wrong(type, "nominal", "a number other than 0");
  }

  void read_start(pugi::xml_node type, Variable& v) const {
    if (!v.start || !is_number(v.type)) return;
    if (v.type != Type::boolean)
      v.start_values = xml_.numbers(type, "start").value_or(std::vector<double>());
    else
      for (const bool one : xml_.flags(type, "start")) v.start_values.push_back(one ? 1.0 : 0.0);
    if (v.start_values.size() > 1 && !type.child("Dimension")) xml_.wrong(type, "start", "one number");
  }

  using Items = std::map<std::string, double>;
  std::shared_ptr<const Items> items_of(pugi::xml_node declared) const {
    Items all;
    for (const pugi::xml_node item : declared.children("Item"))
      if (const auto value = xml_.number(item, "value")) all[xml_.text(item, "name").value_or("")] = *value;
    return std::make_shared<const Items>(std::move(all));
  }

  void read_items(pugi::xml_node declared, Variable& v) {
    auto& items = items_[declared.offset_debug()];
    if (!items) items = items_of(declared);
    v.items = items;
    if (items->empty()) return;
    double first = std::numeric_limits<double>::infinity(), last = -first;
    for (const auto& [name, value] : *items) first = std::min(first, value), last = std::max(last, value);
    v.min = std::max(v.min, first), v.max = std::min(v.max, last);
  }

  /// They lead to variables that may come later: in 2.0 by number, in 3.0 by reference.
  void read_links(pugi::xml_node type, Variable& v) const {
    if (type.attribute("derivative")) v.derivative_of = linked(type, "derivative");
    for (const pugi::xml_node node : type.children("Dimension")) {
      constexpr std::int64_t most = std::int64_t{1} << 31;
      Dimension one{static_cast<std::uint64_t>(xml_.whole(node, "start", 0, most).value_or(0))};
      if (node.attribute("valueReference")) one.variable = linked(node, "valueReference");
      v.dimensions.push_back(one);
    }
  }

  int linked(pugi::xml_node node, const char* name) const {
    if (version_ == Version::two) return static_cast<int>(*xml_.whole(node, name, 1, std::ssize(all_))) - 1;
    const auto reference = xml_.whole(node, name, 0, std::numeric_limits<std::uint32_t>::max());
    const auto it = by_reference_.find(static_cast<std::uint32_t>(*reference));
    if (it == by_reference_.end()) xml_.wrong(node, name, "the valueReference of a variable");
    return it->second;
  }

  const Xml& xml_;
  Version version_;
  const std::map<std::string, Type>& types_;
  std::map<std::string, pugi::xml_node> declared_;
  std::map<std::string, std::string> units_;
  std::unordered_set<std::string> names_;
  std::map<std::uint32_t, int> by_reference_;
  std::map<std::ptrdiff_t, std::shared_ptr<const Items>> items_;  ///< by the place of their type
  std::vector<std::pair<std::size_t, pugi::xml_node>> type_nodes_;
  std::vector<Variable> all_;
};

}  // namespace

std::vector<Variable> read_variables(const Xml& xml, pugi::xml_node root, Version version) {
  return VariableReader(xml, root, version).read(root.child("ModelVariables"));
}

}  // namespace tandem::fmi
