// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fmt/format.h>

#include "tandem/charts/chart.hpp"

namespace tandem::charts {

using text::Section;

// Values of a section by their keys. All throw Error with the place, the value found and what is allowed.

/// A text, or an array of them; empty if it is not there.
std::vector<std::string> one_or_more(Section& section, const std::string& key);
/// Nothing if it is not there.
std::optional<Quantity> quantity(Section& section, const std::string& key);
/// A quantity, an array of them, or an array with arrays of those that share a panel. It has to be there.
std::vector<std::vector<Quantity>> quantities(Section& section, const std::string& key);
std::vector<double> numbers(Section& section, const std::string& key);
/// Words by words, of a table `key` of the section.
std::map<std::string, std::string> names_in(const Section& section, const toml::table& table,
                                            const std::string& key);

/// The tables in an array, each read by `one`.
template <class One>
void tables(Section& section, const std::string& key, const One& one) {
  const toml::node* found = section.node(key);
  if (!found) return;
  const toml::array* array = found->as_array();
  if (!array || !array->is_array_of_tables())
    section.wrong(key, text::described(*found), "an array of tables { .. }");
  for (std::size_t k = 0; k < array->size(); ++k) {
    Section inner(section.document(), *array->get(k)->as_table(),
                  fmt::format("{}[{}]", section.name(key), k));
    one(inner);
    inner.refuse_unknown();
  }
}

}  // namespace tandem::charts
