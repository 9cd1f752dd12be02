// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reader.hpp"
#include "tandem/nearest.hpp"

namespace tandem::mbs {

/// The name of an output, or a table with an element and one of its quantities.
Output Reader::signal(Section& section) const {
  const toml::node* node = section.node("signal");
  if (!node) section.missing("signal", "the name of an output, or { element = .., quantity = .. }");
  if (const auto* table = node->as_table()) {
    Section inner(document_, *table, section.name("signal"), &values_);
    Output quantity{"", Output::Kind::quantity};
    read_element_quantity(inner, inner.required_text("element", "the name of an element"), quantity);
    inner.refuse_unknown();
    return quantity;
  }
  const std::string name = section.required_text("signal", "the name of an output");
  std::vector<std::string> known;
  for (const Output& output : to_.outputs) {
    if (output.name == name) return output;
    known.push_back(output.name);
  }
  text::refuse(section.place("signal"), section.name("signal") + ": " + unknown("output", name, known));
}

void Reader::read_limit(const std::string& name, Section& section) {
  static const std::vector<std::string> words = {"ignore", "warn", "stop"};
  const auto low = section.number("low"), high = section.number("high");
  if (!low && !high) section.missing("low", "a number at low, at high, or at both");
  if (low && high && !(*low < *high))
    section.wrong("low", fmt::format("{}", *low), fmt::format("one below high, {}", *high));
  const std::string word = section.text("on_leaving").value_or("warn");
  const auto it = std::find(words.begin(), words.end(), word);
  if (it == words.end()) section.wrong("on_leaving", "'" + word + "'", listed(words));
  to_.limits.push_back({name, signal(section), low.value_or(-HUGE_VAL), high.value_or(HUGE_VAL),
                        section.required_text("sentence", "why, a text"),
                        static_cast<Limit::OnLeaving>(it - words.begin())});
}

}  // namespace tandem::mbs
