// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "read_values.hpp"

#include "tandem/text/expression.hpp"

namespace tandem::charts {
namespace {

Quantity quantity(const Section& section, const toml::node& node, const std::string& name) {
  const auto* text = node.as_string();
  if (!text)
    refuse(section.document().place(node),
           name + " holds " + text::described(node) + "; allowed is a column, or an expression, in quotes");
  Quantity one{text->get(), section.document().place(node)};
  located(one.place, [&] { text::names_in(one.text); });
  return one;
}

}  // namespace

std::vector<std::string> one_or_more(Section& section, const std::string& key) {
  const toml::node* found = section.node(key);
  if (found && found->is_string()) return {found->as_string()->get()};
  return section.texts(key);
}

std::optional<Quantity> quantity(Section& section, const std::string& key) {
  const toml::node* found = section.node(key);
  return found ? std::optional(quantity(section, *found, section.name(key))) : std::nullopt;
}

std::vector<std::vector<Quantity>> quantities(Section& section, const std::string& key) {
  const toml::node* found = section.node(key);
  if (!found) section.missing(key);
  const toml::array* array = found->as_array();
  if (!array) return {{quantity(section, *found, section.name(key))}};
  std::vector<std::vector<Quantity>> all;
  for (const toml::node& element : *array) {
    all.emplace_back();
    if (const toml::array* inner = element.as_array())
      for (const toml::node& one : *inner) all.back().push_back(quantity(section, one, section.name(key)));
    else
      all.back().push_back(quantity(section, element, section.name(key)));
    if (all.back().empty()) section.wrong(key, "an array with an empty one", "at least one quantity in each");
  }
  if (all.empty()) section.wrong(key, "empty", "at least one quantity");
  return all;
}

std::vector<double> numbers(Section& section, const std::string& key) {
  std::vector<double> all;
  const toml::node* found = section.node(key);
  if (!found) return all;
  if (!found->is_array()) section.wrong(key, text::described(*found), "an array of numbers");
  for (const toml::node& one : *found->as_array()) all.push_back(section.number_of(one, section.name(key)));
  return all;
}

std::map<std::string, std::string> names_in(const Section& section, const toml::table& table,
                                            const std::string& key) {
  std::map<std::string, std::string> names;
  for (const auto& [word, node] : text::in_file_order(table)) {
    if (!node->is_string())
      refuse(section.document().place(*node),
             section.name(key) + "." + word + " is " + text::described(*node) + "; allowed is a text");
    names[word] = node->as_string()->get();
  }
  return names;
}

}  // namespace tandem::charts
