// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "read_search.hpp"

#include <cmath>

#include "axes.hpp"

namespace tandem::study {

namespace {

std::optional<double> number_or_infinity(text::Section& section, const std::string& key) {
  const toml::node* found = section.node(key);
  if (!found) return {};
  const auto value = found->value<double>();
  if (!value || std::isnan(*value)) section.wrong(key, text::described(*found), "a number, or inf");
  return value;
}

}  // namespace

Search read_search(text::Section& section) {
  Search one{.column = section.required_text("column"),
             .from = section.required_number("from"),
             .to = section.required_number("to"),
             .largest = *section.text("find") == "largest",
             .holds = {section.required_text("holds"), section.place("holds")},
             .precision = *section.positive("precision"),
             .scan = section.positive("scan"),
             .nowhere = number_or_infinity(section, "nowhere"),
             .everywhere = number_or_infinity(section, "everywhere")};
  if (one.scan && !(*one.scan > 1.0))
    section.wrong("scan", text::described(*section.node("scan")), "a factor above 1");
  if (!is_column_name(one.column))
    section.wrong("column", "'" + one.column + "'", "letters, digits and _, no digit first");
  if (!(one.from < one.to))
    section.wrong("to", text::described(*section.node("to")), "a number above " + section.name("from"));
  return one;
}

}  // namespace tandem::study
