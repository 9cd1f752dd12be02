// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "read_link.hpp"

namespace tandem::scenario {
namespace {

using text::described;
using text::Section;

StatedLink read_spring(Section& section, double stiffness) {
  const toml::node* both = section.node("displacement");
  if (!both) section.missing("displacement");
  const auto* array = both->as_array();
  if (!array || array->size() != 2)
    section.wrong("displacement", described(*both), "with stiffness: two outputs, of the ends of the spring");
  section.leave_out("effort", "a spring between two displacements has none");
  section.leave_out("flow", "a spring between two displacements has none");
  const auto ends = section.texts("displacement");
  return {ends[0], ends[1], PowerLink::Kind::stiffness, stiffness};
}

StatedLink read_effort(Section& section) {
  const auto effort = section.text("effort"), flow = section.text("flow");
  const toml::node* displacement = section.node("displacement");
  if (!effort) section.missing("effort");
  if (flow && displacement) section.wrong("displacement", "given beside flow", "one of them");
  if (flow) return {*effort, *flow, PowerLink::Kind::flow};
  if (!displacement) section.missing("flow");
  return {*effort, *section.text("displacement"), PowerLink::Kind::displacement};
}

/// One output, or several.
std::vector<std::string> read_accelerance(Section& section) {
  const toml::node* node = section.node("accelerance");
  if (!node) return {};
  if (section.node("effective_mass"))
    section.wrong("effective_mass", "given beside accelerance", "one of them");
  if (node->is_string()) return {*section.text("accelerance")};
  if (!node->is_array()) section.wrong("accelerance", described(*node), "an output, or an array of outputs");
  return section.texts("accelerance");
}

}  // namespace

LinkEntry read_link(Section& section) {
  const auto stiffness = section.positive("stiffness");
  LinkEntry entry{
      stiffness ? read_spring(section, *stiffness) : read_effort(section),
      section.place(),
      {section.positive("effective_mass"), section.positive("effective_stiffness"),
       section.positive("effective_damping"), read_accelerance(section), section.text("velocity")}};
  section.refuse_unknown();
  if (entry.effective.damping && !entry.effective.stiffness)
    section.wrong("effective_damping", "given alone", "it beside effective_stiffness");
  return entry;
}

}  // namespace tandem::scenario
