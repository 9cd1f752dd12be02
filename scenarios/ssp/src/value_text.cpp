// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "value_text.hpp"

#include <fmt/format.h>

#include <charconv>

#include "tandem/nearest.hpp"
#include "tandem/printable.hpp"
#include "tandem/text/place.hpp"
#include "tandem/text/set.hpp"

namespace tandem::ssp {
namespace {

std::string shown(const std::string& name) { return "'" + printable(name, 200) + "'"; }

double number_of(const fmi::Variable& v, const Item& item, const text::Place& place) {
  if (v.items && v.items->count(item.name) != 0) return v.items->at(item.name);
  if (item.number) return *item.number;
  double value = 0.0;
  const char* const end = item.name.data() + item.name.size();
  if (std::from_chars(item.name.data(), end, value).ptr == end) return value;
  std::vector<std::string> known;
  if (v.items)
    for (const auto& [name, one] : *v.items) known.push_back(name);
  text::refuse(place, shown(v.name) + ": " + unknown("item", printable(item.name, 200), known));
}

/// Each kind of value.
struct ValueText {
  const fmi::Variable& v;
  bool as_number;
  text::Place place;

  std::string operator()(double one) const {
    return v.dimensions.empty() ? number(one) : "[" + number(one) + "]";
  }
  std::string operator()(bool flag) const {
    return as_number ? (flag ? "1" : "0") : (flag ? "true" : "false");
  }
  std::string operator()(const std::string& text) const {
    if (as_number) text::refuse(place, "input " + shown(v.name) + " is given a text; allowed is a number");
    return literal(text);
  }
  std::string operator()(const std::vector<double>& all) const {
    std::vector<std::string> texts;
    for (const double one : all) texts.push_back(number(one));
    return "[" + listed(texts) + "]";
  }
  std::string operator()(const Item& item) const { return number(number_of(v, item, place)); }
  std::string operator()(const Unreadable&) const {
    text::refuse(place,
                 shown(v.name) +
                     " is given what can't be taken; allowed are a number, true, false, a text and an item "
                     "of an enumeration");
  }
};

}  // namespace

std::string number(double value) { return fmt::format("{}", value); }

std::string literal(const std::string& text) {
  return text::toml_text(text.starts_with("$") ? "$" + text : text);
}

std::string value_text(const fmi::Variable& v, const Given& given, bool as_number,
                       const std::filesystem::path& file) {
  return std::visit(ValueText{v, as_number, {file.string(), given.line}}, given.value);
}

}  // namespace tandem::ssp
