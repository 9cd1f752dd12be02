// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "values.hpp"

#include <map>
#include <set>
#include <string_view>

#include "tandem/printable.hpp"

namespace tandem::ssp {
namespace {

using fmi::children;

/// A set of parameters, in a file of its own or within one.
struct Set {
  const fmi::Xml& xml;
  xml_node node;
  Definitions defined;
};

Item item(const Set& set, xml_node type) {
  Item one{set.xml.needed_text(type, "value"), {}};
  const auto enumeration = set.defined.enumerations.find(set.xml.text(type, "name").value_or(""));
  if (enumeration == set.defined.enumerations.end()) return one;
  if (const auto it = enumeration->second.find(one.name); it != enumeration->second.end())
    one.number = it->second;
  return one;
}

Given numbers(const Set& set, xml_node type) {
  const auto all = set.xml.numbers(type, "value").value_or(std::vector<double>());
  if (all.empty()) set.xml.wrong(type, "value", "a number");
  Given given{all.front(), fmi::unit_in(set.xml.text(type, "unit").value_or(""), set.defined.units)};
  if (all.size() > 1) given.value = all;
  return given;
}

Given value(const Set& set, xml_node parameter) {
  const xml_node type = type_of(parameter);
  const std::string_view kind = fmi::local_name(type);
  if (kind == "Enumeration") return {item(set, type)};
  if (kind == "Real" || kind.starts_with("Float") || kind.find("Int") != std::string_view::npos)
    return numbers(set, type);
  if (kind != "String" && kind != "Boolean") return {Unreadable()};
  if (!type.attribute("value")) set.xml.wrong(type, "value", kind == "String" ? "a text" : "true or false");
  if (kind == "Boolean") return {set.xml.flag(type, "value")};
  return {std::string(type.attribute("value").value())};
}

std::vector<NamedValue> values_in(const Set& set, const std::string& prefix) {
  std::vector<NamedValue> all;
  for (const xml_node one : children(set.xml.only(set.node, "Parameters"), "Parameter"))
    all.push_back({prefix + set.xml.needed_text(one, "name"), value(set, one)});
  return all;
}

/// Of a file that is not beside the description, or of another kind, nothing is known.
bool names_file(const Document& document, xml_node of, const char* type) {
  if (document.xml.text(of, "type").value_or(type) != type) document.xml.wrong(of, "type", type);
  if (document.xml.text(of, "sourceBase").value_or("SSD") != "SSD")
    document.xml.wrong(of, "sourceBase", "SSD");
  return *of.attribute("source").value() != '\0';
}

std::vector<NamedValue> unmapped(const Document& document, xml_node binding) {
  const std::string prefix = document.xml.text(binding, "prefix").value_or("");
  if (names_file(document, binding, "application/x-ssp-parameter-set")) {
    const Document& file = document.others.open(document.beside(binding, "source"), "ParameterSet");
    return values_in({file.xml, file.root, file.defined}, prefix);
  }
  const xml_node set = document.xml.only(document.xml.only(binding, "ParameterValues"), "ParameterSet");
  if (!set) document.xml.refuse(binding, "a parameter binding has no source and no ParameterSet");
  return values_in({document.xml, set, read_definitions(document.xml, set)}, prefix);
}

/// Those that it names alone, each as often as it does.
std::vector<NamedValue> mapped(const Document& document, xml_node mapping,
                               const std::vector<NamedValue>& from) {
  std::vector<NamedValue> all;
  std::set<std::string> targets;
  std::multimap<std::string_view, const NamedValue*> sources;
  for (const NamedValue& one : from) sources.emplace(one.name, &one);
  for (const xml_node entry : children(mapping, "MappingEntry")) {
    const auto [first, end] = sources.equal_range(entry.attribute("source").value());
    for (auto it = first; it != end; ++it) {
      NamedValue to{document.xml.needed_text(entry, "target"), it->second->given};
      if (!targets.insert(to.name).second)
        document.xml.refuse(entry,
                            "'" + printable(to.name, 200) + "' is given a second value by this mapping");
      to.given.how = read_transformation(document, entry);
      all.push_back(std::move(to));
    }
  }
  return all;
}

}  // namespace

std::vector<NamedValue> values_of(const Document& document, xml_node binding) {
  const std::vector<NamedValue> all = unmapped(document, binding);
  const xml_node mapping = document.xml.only(binding, "ParameterMapping");
  if (!mapping) return all;
  if (names_file(document, mapping, "application/x-ssp-parameter-mapping")) {
    const Document& file = document.others.open(document.beside(mapping, "source"), "ParameterMapping");
    return mapped(file, file.root, all);
  }
  const xml_node inside = document.xml.only(mapping, "ParameterMapping");
  if (!inside) document.xml.refuse(mapping, "a mapping has no source and no ParameterMapping");
  return mapped(document, inside, all);
}

Transformation read_transformation(const Document& document, xml_node of) {
  Transformation how;
  how.keeps_number = document.xml.flag(of, "suppressUnitConversion");
  for (const char* other :
       {"BooleanMappingTransformation", "IntegerMappingTransformation", "EnumerationMappingTransformation"})
    if (const xml_node found = fmi::child(of, other))
      document.xml.refuse(found, std::string(other) + " can't be made; allowed is LinearTransformation");
  if (const xml_node linear = document.xml.only(of, "LinearTransformation")) {
    how.factor = document.xml.number(linear, "factor").value_or(1.0);
    how.offset = document.xml.number(linear, "offset").value_or(0.0);
  }
  return how;
}

}  // namespace tandem::ssp
