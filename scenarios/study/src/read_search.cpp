// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "read_search.hpp"

#include "axes.hpp"

namespace tandem::study {

Search read_search(text::Section& section) {
  Search one{.column = section.required_text("column"),
             .from = section.required_number("from"),
             .to = section.required_number("to"),
             .largest = *section.text("find") == "largest",
             .holds = {section.required_text("holds"), section.place("holds")},
             .precision = *section.positive("precision")};
  if (!is_column_name(one.column))
    section.wrong("column", "'" + one.column + "'", "letters, digits and _, no digit first");
  if (!(one.from < one.to))
    section.wrong("to", text::described(*section.node("to")), "a number above " + section.name("from"));
  return one;
}

}  // namespace tandem::study
