// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "system_description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <pugixml.hpp>
#include <sstream>

#include "model_description.hpp"
#include "tandem/coordinator/units.hpp"
#include "tandem/error.hpp"
#include "tandem/printable.hpp"
#include "tandem/text/set.hpp"

namespace tandem::exported {
namespace {

using pugi::xml_node;
using Attributes = std::vector<std::pair<const char*, std::string>>;

void put(xml_node to, const char* key, const std::string& value) {
  if (printable(value, std::string::npos) != value)
    throw Error(ErrorCode::invalid_argument,
                "'" + printable(value, 200) +
                    "' is a text that XML can't hold; allowed is one without control "
                    "characters");
  to.append_attribute(key).set_value(value.c_str());
}

xml_node add(xml_node to, const std::string& name, const Attributes& attributes = {}) {
  xml_node node = to.append_child(name.c_str());
  for (const auto& [key, value] : attributes) put(node, key, value);
  return node;
}

std::string shortest(double value) { return fmt::format("{}", value); }

/// The elements of SSP 1.0; FMI 3.0 has more types.
const char* type_of(fmi::Type type) {
  if (fmi::is_real(type)) return "Real";
  if (type == fmi::Type::boolean) return "Boolean";
  if (type == fmi::Type::text) return "String";
  return fmi::is_number(type) ? "Integer" : "";
}

void annotate(xml_node to, const std::map<std::string, std::string>& keys) {
  if (keys.empty()) return;
  xml_node content =
      add(add(add(to, "ssd:Annotations"), "ssc:Annotation", {{"type", "org.tandem.coordination"}}),
          "tandem:keys");
  for (const auto& [key, value] : keys) put(content, key.c_str(), value);
}

class SystemWriter {
 public:
  SystemWriter(const scenario::Scenario& scenario, const std::vector<SystemMember>& members)
      : scenario_(scenario), members_(members) {}

  std::string text(const std::string& tool) {
    xml_node declaration = document_.append_child(pugi::node_declaration);
    declaration.append_attribute("version").set_value("1.0");
    declaration.append_attribute("encoding").set_value("UTF-8");
    xml_node root = add(document_, "ssd:SystemStructureDescription", head(tool));
    write_system(add(root, "ssd:System", {{"name", name()}}));
    write_units(root);
    add(root, "ssd:DefaultExperiment",
        {{"startTime", shortest(scenario_.start)}, {"stopTime", shortest(scenario_.stop)}});
    annotate(root, coordination());
    std::ostringstream out;
    document_.save(out, "  ");
    return out.str();
  }

 private:
  std::string name() const { return scenario_.name.empty() ? "system" : printable(scenario_.name, 1000); }

  Attributes head(const std::string& tool) const {
    const std::string standard = "http://ssp-standard.org/SSP1/SystemStructure";
    Attributes all{{"version", "1.0"}, {"name", name()}, {"generationTool", tool}};
    if (!scenario_.description.empty())
      all.emplace_back("description", printable(scenario_.description, std::string::npos));
    all.emplace_back("xmlns:ssc", standard + "Common");
    all.emplace_back("xmlns:ssd", standard + "Description");
    all.emplace_back("xmlns:ssv", standard + "ParameterValues");
    all.emplace_back("xmlns:tandem", "urn:tandem:coordination");
    return all;
  }

  void write_system(xml_node system) {
    xml_node elements = add(system, "ssd:Elements");
    for (const SystemMember& member : members_)
      scenario::located(member.place, [&] { write_component(elements, member); });
    xml_node connections;
    for (const scenario::ConnectionEntry& entry : scenario_.connections)
      scenario::located(entry.place, [&] {
        if (!connections) connections = add(system, "ssd:Connections");
        write_connection(connections, entry.connection);
      });
  }

  void write_component(xml_node elements, const SystemMember& member) {
    xml_node component = add(elements, "ssd:Component",
                             {{"name", member.name},
                              {"type", "application/x-fmu-sharedlibrary"},
                              {"source", "resources/" + file_of(member.name)}});
    std::map<std::string, std::string> keys = member.annotation;
    if (const auto type = keys.find("type"); type != keys.end()) {
      const bool exchanges_model = type->second == "me";
      component.append_attribute("implementation")
          .set_value(exchanges_model ? "ModelExchange" : "CoSimulation");
      keys.erase(type);
    }
    write_connectors(component, member);
    write_values(component, member);
    annotate(component, keys);
  }

  void write_connectors(xml_node component, const SystemMember& member) {
    xml_node connectors;
    for (const fmi::Variable& v : member.description.variables) {
      const bool input = v.causality == fmi::Causality::input, output = v.causality == fmi::Causality::output;
      if (!input && !output) continue;
      if (!connectors) connectors = add(component, "ssd:Connectors");
      xml_node one =
          add(connectors, "ssd:Connector", {{"name", v.name}, {"kind", input ? "input" : "output"}});
      if (const std::string type = type_of(v.type); !type.empty())
        write_unit(add(one, "ssc:" + type), member, v);
    }
  }

  /// The standard wants base units of each that is named.
  void write_unit(xml_node type, const SystemMember& member, const fmi::Variable& v) {
    const std::string unit = member.unit_of(v.name);
    if (!fmi::is_real(v.type) || !base_unit(unit)) return;
    type.append_attribute("unit").set_value(fmi_unit(unit).c_str());
    units_.try_emplace(fmi_unit(unit), unit);
  }

  void write_values(xml_node component, const SystemMember& member) {
    if (member.values.empty()) return;
    xml_node binding = add(add(component, "ssd:ParameterBindings"), "ssd:ParameterBinding");
    xml_node set = add(add(binding, "ssd:ParameterValues"), "ssv:ParameterSet",
                       {{"version", "1.0"}, {"name", member.name}});
    xml_node parameters = add(set, "ssv:Parameters");
    for (const auto& [name, value] : member.values) {
      const std::string type = type_in(member, name);
      add(add(parameters, "ssv:Parameter", {{"name", name}}), "ssv:" + type,
          {{"value", value_in(member, name, type, value)}});
    }
  }

  /// As the schema wants it.
  static std::string value_in(const SystemMember& member, const std::string& name, const std::string& type,
                              const std::string& value) {
    const bool is_whole = value.find_first_not_of("+-0123456789") == std::string::npos;
    const bool yes = value == "true" || value == "1", no = value == "false" || value == "0";
    if ((type == "Integer" && !is_whole) || (type == "Boolean" && !yes && !no))
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("subsystem '{}' gives '{}' {}; allowed is {}", member.name, name, value,
                              type == "Integer" ? "a whole number" : "true or false"));
    return type == "Boolean" ? (yes ? "true" : "false") : value;
  }

  static const char* type_in(const SystemMember& member, const std::string& name) {
    for (const fmi::Variable& v : member.description.variables)
      if (v.name == name && v.size == 1 && *type_of(v.type) != '\0') return type_of(v.type);
    throw Error(ErrorCode::invalid_argument,
                fmt::format("subsystem '{}' is given '{}', an array; SSP 1.0 has words for scalars alone",
                            member.name, name));
  }

  /// The member and the variables of a port.
  std::pair<const SystemMember*, std::vector<std::string>> end(const std::string& port, bool output) const {
    const auto dot = port.find('.');
    const auto it = std::find_if(members_.begin(), members_.end(),
                                 [&](const SystemMember& m) { return m.name == port.substr(0, dot); });
    return {&*it, it->variables(port.substr(dot + 1), output)};
  }

  void write_connection(xml_node connections, const Connection& c) {
    if (c.add)
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("the connection from {} to {} adds to others (add); a "
                              "system has no words for a sum",
                              c.from, c.to));
    const auto [source, outputs] = end(c.from, true);
    const auto [reader, inputs] = end(c.to, false);
    if (outputs.size() != inputs.size())
      throw Error(
          ErrorCode::invalid_argument,
          fmt::format("the connection from {} to {} joins an array of an FMU to single variables, which "
                      "SSP 1.0 has no words for",
                      c.from, c.to));
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      xml_node one = add(connections, "ssd:Connection",
                         {{"startElement", source->name},
                          {"startConnector", outputs[k]},
                          {"endElement", reader->name},
                          {"endConnector", inputs[k]}});
      check_is_output(*source, outputs[k]);
      if (!c.convert && differ(source->unit_of(outputs[k]), reader->unit_of(inputs[k])))
        put(one, "suppressUnitConversion", "true");
      if (c.gain != 1.0 || c.offset != 0.0)
        add(one, "ssc:LinearTransformation", {{"factor", shortest(c.gain)}, {"offset", shortest(c.offset)}});
      annotate(one, keys_of(c));
    }
  }

  static bool differ(const std::string& from, const std::string& to) {
    return from != to && !from.empty() && !to.empty();
  }

  static void check_is_output(const SystemMember& member, const std::string& variable) {
    for (const fmi::Variable& v : member.description.variables)
      if (v.name == variable && v.causality != fmi::Causality::output)
        throw Error(ErrorCode::invalid_argument, fmt::format("'{}.{}' is no output of its FMU; SSP connects "
                                                             "outputs alone",
                                                             member.name, variable));
  }

  static std::map<std::string, std::string> keys_of(const Connection& c) {
    std::map<std::string, std::string> keys;
    if (c.how) keys["reconstruction"] = c.how->name();
    if (c.lag == Lag::memory) keys["memory"] = "true";
    if (c.lag == Lag::delay) keys["delay"] = "true";
    return keys;
  }

  void write_units(xml_node root) const {
    if (units_.empty()) return;
    xml_node to = add(root, "ssd:Units");
    for (const auto& [name, unit] : units_)
      write_base(add(add(to, "ssc:Unit", {{"name", name}}), "ssc:BaseUnit"), *base_unit(unit));
  }

  std::map<std::string, std::string> coordination() const {
    const Coordination& c = scenario_.coordination;
    std::map<std::string, std::string> keys{{"schedule", std::string(Schedule::name(c.schedule))},
                                            {"start", std::string(tandem::name(c.start))}};
    if (c.communication_step) keys["communication_step"] = shortest(*c.communication_step);
    std::string order;
    const auto add_name = [&](const std::string& name) {
      order += (order.empty() ? "" : ", ") + text::toml_text(name);
    };
    for (const std::string& one : c.order) add_name(one);
    for (const SystemMember& member : members_)  // what samples integrates itself there
      if (!c.order.empty() && std::find(c.order.begin(), c.order.end(), member.name) == c.order.end())
        add_name(member.name);
    if (!order.empty()) keys["order"] = "[" + order + "]";
    return keys;
  }

  const scenario::Scenario& scenario_;
  const std::vector<SystemMember>& members_;
  pugi::xml_document document_;
  std::map<std::string, std::string> units_;  ///< that connectors have, by their names in the file
};

}  // namespace

std::string file_of(const std::string& component) {
  std::string name;
  for (const char c : component) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = std::isalnum(byte) || c == '_' || c == '-';
    name += plain ? std::string(1, c) : fmt::format("~{:02x}", byte);
  }
  return name + ".fmu";
}

std::string system_description(const scenario::Scenario& scenario, const std::vector<SystemMember>& members,
                               const std::string& tool) {
  return SystemWriter(scenario, members).text(tool);
}

}  // namespace tandem::exported
