// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "read_ladder.hpp"

#include <algorithm>

#include "settings.hpp"

namespace tandem::scenario {
namespace {

using text::described;
using text::Section;

LadderQuantity read_judged(Section& section, const Scenario& of) {
  LadderQuantity judged{section.required_text("quantity"), section.required_number("tolerance"),
                        section.text("unit").value_or(""), section.place("quantity"),
                        read_measure(section, of)};
  section.refuse_unknown();
  return judged;
}

/// Judged quantities by another name, or as a number.
void read_outputs(Section& section, const std::vector<LadderQuantity>& quantities, LadderRung& rung) {
  const toml::table* table = section.table("outputs");
  if (!table) return;
  for (const auto& [quantity, node] : text::in_file_order(*table)) {
    const bool judged = std::any_of(quantities.begin(), quantities.end(),
                                    [&](const LadderQuantity& q) { return q.quantity == quantity; });
    if (!judged || !(node->is_string() || node->is_number()))
      section.wrong("outputs", quantity + " = " + described(*node),
                    "a judged quantity and the output, or the number, that it is here");
    if (const auto* name = node->as_string())
      rung.outputs[quantity] = name->get();
    else
      rung.constants[quantity] =
          text::number_of(section.document(), *node, section.name("outputs." + quantity));
  }
}

LadderRung read_rung(Section& section, const Scenario& scenario, const LadderEntry& ladder,
                     std::vector<std::string> overrides) {
  LadderRung rung;
  rung.name = section.required_text("name");
  rung.place = section.place();
  if (rung.name.find_first_of("/\\\"") != std::string::npos || rung.name.starts_with("."))
    section.wrong("name", "'" + rung.name + "'", "a name without / \\ \" and a dot at its beginning");
  if (rung.name == "ladder.csv" || rung.name == "ladder.json" || rung.name == "verdict.txt")
    section.wrong("name", "'" + rung.name + "'", "a name that no file of the ladder has");
  const bool twice = std::any_of(ladder.rungs.begin(), ladder.rungs.end(),
                                 [&](const LadderRung& other) { return other.name == rung.name; });
  if (twice) section.wrong("name", "'" + rung.name + "' again", "a name that no other rung has");
  const auto file = section.text("file");
  rung.file = file ? scenario.file.parent_path() / *file : scenario.file;
  if (file) overrides.clear();
  for (std::string& text : section.texts("set")) overrides.push_back(std::move(text));
  rung.overrides = std::move(overrides);
  read_outputs(section, ladder.quantities, rung);
  section.refuse_unknown();
  return rung;
}

}  // namespace

void read_ladder(Section& section, Scenario& to) {
  LadderEntry ladder;
  const auto overrides = section.texts("set");
  for (Section& judged : section.sections("judged")) ladder.quantities.push_back(read_judged(judged, to));
  if (ladder.quantities.empty() && to.judge)
    ladder.quantities.push_back(
        {to.judge->quantity, to.judge->tolerance, "", to.judge->place, to.judge->measure});
  if (ladder.quantities.empty())
    section.missing("judged", "tables [[ladder.judged]] with quantity and tolerance, or a table [judge]");
  for (Section& rung : section.sections("rungs"))
    ladder.rungs.push_back(read_rung(rung, to, ladder, overrides));
  if (ladder.rungs.size() < 2)
    section.missing("rungs", "two or more tables [[ladder.rungs]], the richest last");
  section.refuse_unknown();
  to.ladder = std::move(ladder);
}

}  // namespace tandem::scenario
