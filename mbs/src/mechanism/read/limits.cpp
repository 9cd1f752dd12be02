// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/text/limits.hpp"

#include "reader.hpp"
#include "tandem/nearest.hpp"

namespace tandem::mbs {

/// The name of an output, or a table with an element and one of its quantities.
Output Reader::signal(Section& section) const {
  const toml::node* node = section.node("signal");
  if (!node) section.missing("signal");
  if (const auto* table = node->as_table()) {
    Section inner(document_, *table, section.name("signal"), &values_);
    Output quantity{"", Output::Kind::quantity};
    read_element_quantity(inner, inner.required_text("element", "the name of an element"), quantity);
    inner.refuse_unknown();
    return quantity;
  }
  const std::string name = section.required_text("signal");
  std::vector<std::string> known;
  for (const Output& output : to_.outputs) {
    if (output.name == name) return output;
    known.push_back(output.name);
  }
  text::refuse(section.place("signal"), section.name("signal") + ": " + unknown("output", name, known));
}

void Reader::read_limit(const std::string& name, Section& section) {
  const text::FileLimit read = text::read_limit(section);
  to_.limits.push_back({name, signal(section), read.low, read.high, read.sentence,
                        static_cast<Limit::OnLeaving>(read.on_leaving)});
}

}  // namespace tandem::mbs
