// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "model_description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <pugixml.hpp>
#include <sstream>

#include "model_structure.hpp"
#include "tandem/coordinator/units.hpp"

namespace tandem::exported {
namespace {

using Kind = Variable::Kind;
using pugi::xml_node;

std::string number(double value) { return fmt::format("{}", value); }

class Writer {
 public:
  Writer(const Unit& unit, const Facts& facts, fmi::Version version)
      : unit_(unit),
        facts_(facts),
        two_(version == fmi::Version::two),
        exchange_(unit.manifest().interface == Interface::model_exchange) {}

  std::string text() {
    xml_node declaration = document_.append_child(pugi::node_declaration);
    put(declaration, "version", "1.0");
    put(declaration, "encoding", "UTF-8");
    root_ = document_.append_child("fmiModelDescription");
    write_head();
    exchange_ ? write_model_exchange() : write_co_simulation();
    write_units();
    write_categories();
    write_experiment();
    xml_node variables = root_.append_child("ModelVariables");
    for (std::size_t k = 0; k < unit_.variables().size(); ++k) write_variable(variables, k);
    write_structure(root_.append_child("ModelStructure"), unit_, two_);
    std::ostringstream out;
    document_.save(out, "  ");
    return out.str();
  }

 private:
  static void put(xml_node to, const char* name, const std::string& value) {
    to.append_attribute(name).set_value(value.c_str());
  }

  void write_head() {
    put(root_, "fmiVersion", two_ ? "2.0" : "3.0");
    put(root_, "modelName", facts_.name);
    put(root_, two_ ? "guid" : "instantiationToken", unit_.manifest().token);
    if (!facts_.description.empty()) put(root_, "description", facts_.description);
    put(root_, "generationTool", facts_.tool);
    put(root_, "variableNamingConvention", "flat");
    if (two_)
      put(root_, "numberOfEventIndicators", std::to_string(of_kinds(unit_, {Kind::indicator}).size()));
  }

  void write_model_exchange() {
    xml_node to = root_.append_child("ModelExchange");
    put(to, "modelIdentifier", facts_.identifier);
    if (!two_) put(to, "needsCompletedIntegratorStep", "true");
    write_abilities(to);
  }

  void write_co_simulation() {
    xml_node to = root_.append_child("CoSimulation");
    put(to, "modelIdentifier", facts_.identifier);
    put(to, "canHandleVariableCommunicationStepSize", "true");
    if (two_) put(to, "canInterpolateInputs", "true");
    put(to, "maxOutputDerivativeOrder", std::to_string(least_derivatives()));
    write_abilities(to);
  }

  void write_abilities(xml_node to) {
    const std::string keeps = unit_.keeps_state() ? "true" : "false";
    if (two_) put(to, "canNotUseMemoryManagementFunctions", "true");
    put(to, two_ ? "canGetAndSetFMUstate" : "canGetAndSetFMUState", keeps);
    put(to, two_ ? "canSerializeFMUstate" : "canSerializeFMUState", keeps);
  }

  /// The standard has one order for all outputs.
  int least_derivatives() const {
    int least = TANDEM_MAX_COEFFICIENTS;
    const auto outputs = of_kinds(unit_, {Kind::output});
    for (const std::size_t k : outputs) least = std::min(least, at(k).order);
    return outputs.empty() ? 0 : least;
  }

  void write_units() {
    std::map<std::string, std::string> units;  // two texts of tandem may be one of FMI
    for (const Variable& v : unit_.variables())
      if (has_unit(v)) units.try_emplace(fmi_unit(v.unit), v.unit);
    if (units.empty()) return;
    xml_node to = root_.append_child("UnitDefinitions");
    for (const auto& [name, unit] : units) {
      xml_node one = to.append_child("Unit");
      put(one, "name", name);
      if (const auto base = base_unit(unit)) write_base(one.append_child("BaseUnit"), *base);
    }
  }

  static bool has_unit(const Variable& v) { return !v.unit.empty(); }

  void write_categories() {
    xml_node to = root_.append_child("LogCategories");
    for (const char* name : {"logStatusWarning", "logStatusError"})
      put(to.append_child("Category"), "name", name);
  }

  void write_experiment() {
    xml_node to = root_.append_child("DefaultExperiment");
    if (facts_.span) {
      put(to, "startTime", number(facts_.span->start));
      put(to, "stopTime", number(facts_.span->stop));
    }
    put(to, "stepSize", number(facts_.step));
  }

  void write_role(xml_node to, const Variable& v) const {
    const char* causality = "local";
    const char* variability = v.held ? "discrete" : "continuous";
    if (v.kind == Kind::time) causality = "independent";
    if (v.kind == Kind::input) causality = "input";
    if (v.kind == Kind::output) causality = "output";
    if (v.kind >= Kind::number) causality = "parameter", variability = "fixed";
    put(to, "causality", causality);
    put(to, "variability", variability);
    if (v.kind >= Kind::number) put(to, "initial", "exact");
  }

  const char* type_of(const Variable& v) const {
    if (v.kind == Kind::word) return "String";
    return v.kind == Kind::extrapolate ? "Boolean" : two_ ? "Real" : "Float64";
  }

  /// Of 2.0 the type is an element of its own.
  void write_variable(xml_node variables, std::size_t k) {
    const Variable& v = at(k);
    xml_node to = variables.append_child(two_ ? "ScalarVariable" : type_of(v));
    put(to, "name", v.name);
    put(to, "valueReference", std::to_string(k));
    write_role(to, v);
    write_value(two_ ? to.append_child(type_of(v)) : to, k);
  }

  void write_value(xml_node to, std::size_t k) {
    const Variable& v = at(k);
    if (has_unit(v)) put(to, "unit", fmi_unit(v.unit));
    if (v.kind == Kind::input || v.kind == Kind::number) put(to, "start", number(v.start));
    if (v.kind == Kind::extrapolate) put(to, "start", "false");
    if (v.reset) put(to, "reinit", "true");
    if (v.kind == Kind::word)
      two_ ? put(to, "start", v.word) : put(to.append_child("Start"), "value", v.word);
    if (v.kind == Kind::derivative || v.kind == Kind::rate) put(to, "derivative", reference_of(k - 1, two_));
  }

  const Variable& at(std::size_t k) const { return unit_.variables()[k]; }

  const Unit& unit_;
  const Facts& facts_;
  bool two_, exchange_;
  pugi::xml_document document_;
  xml_node root_;
};

}  // namespace

std::string fmi_unit(const std::string& unit) {
  std::string text = unit;
  std::replace(text.begin(), text.end(), ' ', '.');
  std::erase(text, '^');
  return text;
}

void write_base(xml_node to, const BaseUnit& base) {
  const auto put = [&](const char* name, const std::string& value) {
    to.append_attribute(name).set_value(value.c_str());
  };
  for (std::size_t k = 0; k < base.names.size(); ++k)
    if (base.exponents[k] != 0) put(base.names[k], std::to_string(base.exponents[k]));
  if (base.factor != 1.0) put("factor", number(base.factor));
  if (base.offset != 0.0) put("offset", number(base.offset));
}

std::string identifier_of(const std::string& text) {
  std::string name;
  for (const char c : text) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name.empty() || std::isdigit(static_cast<unsigned char>(name[0])) ? "_" + name : name;
}

std::string model_description(const Unit& unit, const Facts& facts, fmi::Version version) {
  return Writer(unit, facts, version).text();
}

}  // namespace tandem::exported
