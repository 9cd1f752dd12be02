// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/fmi/unit_definitions.hpp"

#include <cctype>
#include <cmath>

#include "tandem/coordinator/units.hpp"

namespace tandem::fmi {
namespace {

/// "N.m/rad", "m/s2" as "N m/rad", "m/s^2".
std::string in_our_form(const std::string& unit) {
  if (unit == "r/min" || unit == "rev/min") return "rpm";
  std::string text;
  for (std::size_t k = 0; k < unit.size(); ++k) {
    const auto at = [&](std::size_t i) { return i < unit.size() ? static_cast<unsigned char>(unit[i]) : 0; };
    const bool power = std::isdigit(at(k)) || (at(k) == '-' && std::isdigit(at(k + 1)));
    if (power && k > 0 && std::isalpha(at(k - 1))) text += '^';
    text += unit[k] == '.' ? ' ' : unit[k];
  }
  return text;
}

BaseUnit read_base(const Xml& xml, pugi::xml_node node) {
  constexpr std::int64_t most = 99;
  BaseUnit base;
  for (std::size_t k = 0; k < base.names.size(); ++k)
    base.exponents[k] = static_cast<int>(xml.whole(node, base.names[k], -most, most).value_or(0));
  base.factor = xml.number(node, "factor").value_or(1.0);
  base.offset = xml.number(node, "offset").value_or(0.0);
  if (!(base.factor > 0.0) || !std::isfinite(base.factor)) xml.wrong(node, "factor", "a finite number above 0");
  if (!std::isfinite(base.offset)) xml.wrong(node, "offset", "a finite number");
  return base;
}

}  // namespace

std::map<std::string, std::string> read_units(const Xml& xml, pugi::xml_node definitions) {
  std::map<std::string, std::string> units;
  for (const pugi::xml_node unit : definitions) {
    if (unit.type() != pugi::node_element) continue;
    const std::string name = xml.needed_text(unit, "name");
    std::string text = in_our_form(name);
    for (const pugi::xml_node child : unit)
      if (local_name(child) == "BaseUnit") text = unit_text(text, read_base(xml, child));
    units[name] = text;
  }
  return units;
}

std::string unit_in(const std::string& name, const std::map<std::string, std::string>& defined) {
  const auto it = defined.find(name);
  return it == defined.end() ? in_our_form(name) : it->second;
}

}  // namespace tandem::fmi
