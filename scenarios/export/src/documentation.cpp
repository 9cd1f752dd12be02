// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <pugixml.hpp>
#include <sstream>

#include "model_description.hpp"

namespace tandem::exported {
namespace {

using Kind = Variable::Kind;
using pugi::xml_node;

void add(xml_node to, const char* tag, const std::string& text) {
  to.append_child(tag).append_child(pugi::node_pcdata).set_value(text.c_str());
}

std::string role(const Variable& v) {
  switch (v.kind) {
    case Kind::time:
      return "time";
    case Kind::input:
      return fmt::format("input, {} at the start", v.start);
    case Kind::output:
      return v.held ? "output, constant between its instants" : "output";
    case Kind::derivative:
      return "time derivative of an output";
    case Kind::state:
      return "state that no output shows";
    case Kind::rate:
      return "time derivative of a state";
    case Kind::indicator:
      return "an event is due where its sign changes";
    case Kind::number:
      return fmt::format("parameter, {} unless it is set", v.start);
    case Kind::word:
      return "parameter, '" + v.word + "' unless it is set";
    default:
      return "parameter: true: an input goes on along its last two values";
  }
}

void add_variables(xml_node body, const Unit& unit) {
  xml_node table = body.append_child("table"), head = table.append_child("tr");
  for (const char* title : {"variable", "unit", "what it is"}) add(head, "th", title);
  for (const Variable& v : unit.variables()) {
    xml_node row = table.append_child("tr");
    for (const std::string& cell : {v.name, v.unit, role(v)}) add(row, "td", cell);
  }
}

void add_sentences(xml_node body, const Unit& unit, fmi::Version version) {
  if (unit.info().input_size() > 0) {
    add(body, "p",
        "An input is held over a communication step, and a loop of such FMUs is of the first order in the "
        "step. The "
        "parameter extrapolate, set to true, draws a line through the last two values, which is of the "
        "second order.");
    if (version == fmi::Version::two)
      add(body, "p",
          "Derivatives of inputs (fmi2SetRealInputDerivatives, orders 1 to 5) go before that. They hold for "
          "one step.");
  }
  add(body, "p",
      "Outputs are those of the end of the last step. An output that follows inputs at once follows those "
      "that are set "
      "then, as by a jump.");
  add(body, "p",
      unit.info().abilities.sampled
          ? "It acts at its instants after the begin of a communication step, up to and with the end."
          : "A communication step may have any length; own steps are cut to end with it.");
}

}  // namespace

std::string documentation(const Unit& unit, const Facts& facts, fmi::Version version) {
  pugi::xml_document document;
  document.append_child(pugi::node_doctype).set_value("html");
  xml_node html = document.append_child("html"), head = html.append_child("head");
  head.append_child("meta").append_attribute("charset").set_value("utf-8");
  add(head, "title", facts.name);
  add(head, "style",
      "body { font-family: sans-serif; max-width: 50em; margin: 2em } td, th { padding: 0.2em 0.8em; "
      "text-align: left }");
  xml_node body = html.append_child("body");
  add(body, "h1", facts.name);
  if (!facts.description.empty()) add(body, "p", facts.description);
  add(body, "p",
      fmt::format("An FMU for {}, made by {} from {}. Its {} is {} s.", unit.manifest().interface_name(),
                  facts.tool, unit.manifest().source,
                  unit.info().abilities.sampled ? "sampling period" : "own step", facts.step));
  add_variables(body, unit);
  if (unit.manifest().interface == Interface::co_simulation) add_sentences(body, unit, version);
  std::ostringstream out;
  document.save(out, "  ", pugi::format_default | pugi::format_no_declaration);
  return out.str();
}

}  // namespace tandem::exported
