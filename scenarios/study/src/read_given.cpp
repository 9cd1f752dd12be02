// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "read_given.hpp"

#include <algorithm>

#include "has.hpp"
#include "tandem/nearest.hpp"

namespace tandem::study {
namespace {

using text::Document;
using text::Section;

Given given(const Document& document, const std::string& name, const toml::node& node,
            const std::string& path) {
  Given one{name, {}, document.place(node)};
  if (const auto* word = node.as_string())
    one.value = word->get();
  else if (const auto* flag = node.as_boolean())
    one.value = flag->get();
  else
    one.value = text::number_of(document, node, path);
  return one;
}

}  // namespace

std::optional<Given> one_given(Section& section, const std::string& key) {
  const toml::node* found = section.node(key);
  return found ? std::optional(given(section.document(), key, *found, section.name(key))) : std::nullopt;
}

std::vector<Given> all_given(Section& section, const std::string& key) {
  std::vector<Given> all;
  if (const toml::table* table = section.table(key))
    for (const auto& [name, node] : text::in_file_order(*table))
      all.push_back(given(section.document(), name, *node, section.name(key) + "." + name));
  return all;
}

void check_column(const Place& place, const std::string& what, const std::string& column,
                  const Study& study) {
  const auto known = study.columns();
  if (!has(known, column)) refuse(place, what + ": " + unknown("column", column, known));
}

void check_columns(const Given& one, const std::string& table, const Study& study) {
  for (const std::string& column : one.columns()) check_column(one.place, table + one.name, column, study);
}

}  // namespace tandem::study
