// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/fmi/description.hpp"

#include <algorithm>
#include <cctype>
#include <set>

#include "tandem/printable.hpp"
#include "variables.hpp"
#include "xml.hpp"

namespace tandem::fmi {
namespace {

/// It becomes part of a file's name, so nothing that leads elsewhere.
std::string model_identifier(const Xml& xml, pugi::xml_node of) {
  const std::string name = xml.needed_text(of, "modelIdentifier");
  const bool plain =
      std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
  if (!plain) xml.wrong(of, "modelIdentifier", "a name of letters, digits and _");
  return name;
}

std::optional<Offer> offer(const Xml& xml, pugi::xml_node of) {
  if (!of) return std::nullopt;
  Offer o;
  o.model = model_identifier(xml, of);
  o.needs_tool = xml.flag(of, "needsExecutionTool");
  o.once_per_process = xml.flag(of, "canBeInstantiatedOnlyOncePerProcess");
  o.keeps_state = xml.flag(of, "canGetAndSetFMUstate");
  o.serializes_state = o.keeps_state && xml.flag(of, "canSerializeFMUstate");
  o.interpolates_inputs = xml.flag(of, "canInterpolateInputs");
  o.needs_no_completed_steps = xml.flag(of, "completedIntegratorStepNotNeeded");
  return o;
}

/// Variables are counted from 1 in the text and from 0 here.
std::vector<Unknown> unknowns(const Xml& xml, pugi::xml_node list, int variables) {
  std::vector<Unknown> all;
  for (const pugi::xml_node node : list.children("Unknown")) {
    const auto index = xml.whole(node, "index", 1, variables);
    if (!index) xml.wrong(node, "index", "the number of a variable");
    Unknown unknown{static_cast<int>(*index) - 1};
    const auto of = xml.list(node, "dependencies", 1, variables);
    unknown.of_all = !of;
    for (const int one : of.value_or(std::vector<int>())) unknown.of.push_back(one - 1);
    all.push_back(std::move(unknown));
  }
  return all;
}

void read_structure(const Xml& xml, pugi::xml_node structure, Description& d) {
  const auto variables = static_cast<int>(d.variables.size());
  d.outputs = unknowns(xml, structure.child("Outputs"), variables);
  d.derivatives = unknowns(xml, structure.child("Derivatives"), variables);
  for (const Unknown& state : d.derivatives)
    if (const Variable& v = d.variables[static_cast<std::size_t>(state.variable)];
        v.type != Type::real || v.derivative_of < 0)
      xml.refuse(structure,
                 "variable '" + printable(v.name, 200) +
                     "' is listed as the derivative of a state; allowed is one whose <Real> has the "
                     "attribute derivative");
}

void read_head(const Xml& xml, pugi::xml_node root, Description& d) {
  if (const auto version = xml.text(root, "fmiVersion"); version != "2.0")
    xml.wrong(root, "fmiVersion", "2.0");
  d.name = xml.needed_text(root, "modelName");
  d.guid = xml.text(root, "guid").value_or("");
  d.tool = xml.text(root, "generationTool").value_or("");
  d.text = xml.text(root, "description").value_or("");
  constexpr int most_indicators = 1 << 24;
  d.event_indicators =
      static_cast<int>(xml.whole(root, "numberOfEventIndicators", 0, most_indicators).value_or(0));
  d.co_simulation = offer(xml, root.child("CoSimulation"));
  d.model_exchange = offer(xml, root.child("ModelExchange"));
  if (!d.co_simulation && !d.model_exchange)
    xml.refuse(root, "the FMU offers neither Co-Simulation nor Model Exchange");
  const pugi::xml_node experiment = root.child("DefaultExperiment");
  d.experiment = {xml.number(experiment, "stepSize"), xml.number(experiment, "tolerance")};
}

}  // namespace

Description read_description(const std::string& text, const std::string& file) {
  const Xml xml(text, file);
  const pugi::xml_node root = xml.root("fmiModelDescription");
  Description d;
  read_head(xml, root, d);
  d.variables = read_variables(xml, root);
  read_structure(xml, root.child("ModelStructure"), d);
  return d;
}

/// "N.m/rad", "m/s2" as "N m/rad", "m/s^2".
std::string unit_of_fmi(const std::string& unit) {
  if (unit == "r/min" || unit == "rev/min") return "rpm";
  std::string text;
  for (std::size_t k = 0; k < unit.size(); ++k) {
    const auto at = [&](std::size_t i) { return i < unit.size() ? static_cast<unsigned char>(unit[i]) : 0; };
    const bool power = std::isdigit(at(k)) || (at(k) == '-' && std::isdigit(at(k + 1)));
    if (power && k > 0 && std::isalpha(at(k - 1))) text += '^';
    text += unit[k] == '.' ? ' ' : unit[k];
  }
  return text;
}

}  // namespace tandem::fmi
