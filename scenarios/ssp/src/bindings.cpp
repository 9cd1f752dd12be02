// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "connected.hpp"
#include "tandem/nearest.hpp"
#include "tandem/printable.hpp"
#include "values.hpp"

namespace tandem::ssp {
namespace {

/// To all that have the name from an element on inwards, as names may hold dots. False: none has.
bool assign(Structure& to, int number, const std::string& name, const Given& given) {
  const Element& at = to.at(number);
  bool any = at.is_system() ? at.connectors.count(name) != 0 : to.variable({number, name}) != nullptr;
  if (any) to.given[{number, name}] = given;
  for (auto dot = name.find('.'); at.is_system() && dot <= longest_name; dot = name.find('.', dot + 1))
    if (const auto inner = to.numbers.find({number, name.substr(0, dot)}); inner != to.numbers.end())
      any = assign(to, inner->second, name.substr(dot + 1), given) || any;
  return any;
}

std::string first_of(const std::vector<std::string>& names) {
  constexpr std::size_t most = 5;
  std::vector<std::string> shown;
  for (const std::string& name : names)
    if (shown.size() < most) shown.push_back(printable(name, 100));
  return listed(shown) + (names.size() > most ? ", ..." : "");
}

}  // namespace

void apply_bindings(const Document& document, xml_node of, int line, int element, Structure& to) {
  std::vector<std::string> unused;
  for (const xml_node container : fmi::children(of, "ParameterBindings"))  // some tools write several
    for (const xml_node one : fmi::children(container, "ParameterBinding")) {
      const int own_line = line != 0 ? line : document.xml.line(one);
      for (NamedValue& value : values_of(document, one)) {
        to.count(own_line);
        value.given.line = own_line, value.given.order = ++to.values;
        if (!assign(to, element, value.name, value.given)) unused.push_back(value.name);
      }
    }
  if (!unused.empty())
    to.remarks.push_back(fmt::format("{} values of parameters are left out, as nothing takes them: {}",
                                     unused.size(), first_of(unused)));
}

}  // namespace tandem::ssp
