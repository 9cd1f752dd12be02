// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "chains.hpp"
#include "structure.hpp"
#include "tandem/nearest.hpp"
#include "tandem/printable.hpp"
#include "tandem/ssp/ssp.hpp"
#include "tandem/text/place.hpp"
#include "tandem/text/set.hpp"

namespace tandem::ssp {
namespace {

using text::toml_text;
using text::toml_value;

class Writer {
 public:
  explicit Writer(Structure structure) : in_(std::move(structure)) {
    for (int k = 0; k < static_cast<int>(in_.elements.size()); ++k)
      if (!in_.at(k).is_system()) names_[k] = instance_name(k);
  }

  ScenarioText write() {
    const int line = in_.at(0).line;
    put(line, "name", toml_text(in_.name));
    if (!in_.description.empty()) put(line, "description", toml_text(in_.description));
    for (const auto& [element, name] : names_) write_component(element, name);
    for (const Edge& edge : in_.edges)
      if (names_.count(edge.to.first) != 0) write_connection(edge.to);
    write_coordination(line);
    add(line, "[span]");
    if (in_.start) put(line, "start", number(*in_.start));
    if (in_.stop) put(line, "stop", number(*in_.stop));
    remark();
    return std::move(to_);
  }

 private:
  static std::string number(double value) { return fmt::format("{}", value); }

  void add(int line, const std::string& text) {
    to_.text += text + "\n";
    to_.lines.resize(
        to_.lines.size() + 1 + static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')), line);
  }
  void put(int line, const std::string& key, const std::string& value) { add(line, key + " = " + value); }

  [[noreturn]] void refuse(int line, const std::string& sentence) const {
    text::refuse({in_.file.string(), line}, sentence);
  }

  void remark() {
    to_.remarks.insert(to_.remarks.end(), in_.remarks.begin(), in_.remarks.end());
    if (!in_.unknown_units.empty())
      to_.remarks.push_back("values are taken as they are where a unit is not known: " +
                            listed({in_.unknown_units.begin(), in_.unknown_units.end()}));
  }

  /// Without what stands between names, and once.
  std::string instance_name(int element) {
    std::string name = in_.full_name(element);
    for (char& c : name)
      if (std::string_view(".[] \t\n\r\",/\\").find(c) != std::string_view::npos) c = '_';
    std::string once = name;
    for (int k = 2; !taken_.insert(once).second; ++k) once = name + "_" + std::to_string(k);
    return once;
  }

  void write_component(int number, const std::string& name) {
    const Element& element = in_.at(number);
    const int line = element.line;
    add(line, "[subsystems." + toml_text(name) + "]");
    put(line, "source", toml_text("fmu:" + element.fmu.lexically_proximate(in_.file.parent_path()).string()));
    if (element.implementation == "ModelExchange") put(line, "parameters.type", "\"me\"");
    if (element.implementation == "CoSimulation") put(line, "parameters.type", "\"cs\"");
    for (const auto& [key, value] : element.settings) {
      const bool of_subsystem = key == "land" || key == "isolate";
      put(line, of_subsystem ? key : "parameters." + toml_text(key), toml_value(value));
    }
    write_units(number);
    write_outputs(number);
    write_values(number);
  }

  /// Of ports, where the FMU has others.
  void write_units(int number) {
    for (const auto& [name, connector] : in_.at(number).connectors) {
      const fmi::Variable* found = in_.variable({number, name});
      if (!found) continue;  // a connector that nothing is connected to
      const fmi::Variable& v = *found;
      const bool is_port = v.causality == fmi::Causality::input || v.causality == fmi::Causality::output;
      const auto into = in_.into.find({number, name});
      std::string unit = connector.unit.empty() ? v.unit : connector.unit;
      if (into != in_.into.end()) {
        const Chain chain = chain_to(in_, {number, name});
        if (names_.count(chain.source.first) != 0 && gain_of(in_, chain).keeps_number) unit.clear();
      }
      if (is_port && unit != v.unit)
        put(in_.at(number).line, "parameters.unit." + toml_text(name), toml_text(unit));
    }
  }

  /// Variables that others read and that the FMU does not call outputs.
  void write_outputs(int number) {
    std::set<std::string> more;
    for (const Edge& edge : in_.edges)
      if (edge.from.first == number && in_.variable(edge.from)->causality != fmi::Causality::output)
        more.insert(toml_text(edge.from.second));
    if (more.empty()) return;
    put(in_.at(number).line, "parameters.outputs", "[" + listed({more.begin(), more.end()}) + "]");
  }

  void write_values(int number) {
    std::set<Node> nodes;
    const auto of_this = [&](const auto& all) {
      for (auto it = all.lower_bound({number, ""}); it != all.end() && it->first.first == number; ++it)
        nodes.insert(it->first);
    };
    of_this(in_.given), of_this(in_.into);
    for (const Node& node : nodes) {
      const Chain chain = chain_to(in_, node);
      const bool is_read = !chain.edges.empty() && names_.count(chain.source.first) != 0;
      const fmi::Variable& v = *in_.variable(node);
      if (is_read && v.causality != fmi::Causality::input)
        refuse(chain.line(), "parameter '" + printable(node.second, 200) +
                                 "' is to follow another component; allowed is a value");
      if (const auto given = is_read ? std::nullopt : given_through(in_, chain)) write_value(v, *given);
    }
  }

  void write_value(const fmi::Variable& v, const Given& given) {
    const bool is_input = v.causality == fmi::Causality::input && fmi::is_number(v.type);
    if (is_input && std::holds_alternative<std::string>(given.value))
      refuse(given.line, "input '" + printable(v.name, 200) + "' is given a text; allowed is a number");
    const std::string name = toml_text(is_input ? fmi::port_name(v.name) : v.name);
    put(given.line, (is_input ? "inputs." : "parameters.set.") + name, value_of(given, is_input));
  }

  static std::string value_of(const Given& given, bool as_number) {
    if (const auto* flag = std::get_if<bool>(&given.value))
      return as_number ? (*flag ? "1" : "0") : (*flag ? "true" : "false");
    if (const auto* one = std::get_if<double>(&given.value)) return number(*one);
    if (const auto* text = std::get_if<std::string>(&given.value)) return toml_text(*text);
    std::vector<std::string> texts;
    for (const double one : std::get<std::vector<double>>(given.value)) texts.push_back(number(one));
    return "[" + listed(texts) + "]";
  }

  std::string port(const Node& node) const {
    return toml_text(names_.at(node.first) + "." + fmi::port_name(node.second));
  }

  void write_connection(const Node& to) {
    const Chain chain = chain_to(in_, to);
    if (names_.count(chain.source.first) == 0) return;  // a value, if there is one
    const Gain how = gain_of(in_, chain);
    const int line = chain.line();
    add(line, "[[connections]]");
    put(line, "from", port(chain.source)), put(line, "to", port(to));
    if (how.gain != 1.0) put(line, "gain", number(how.gain));
    if (how.offset != 0.0) put(line, "offset", number(how.offset));
    if (how.converts) put(line, "convert", "true");
    Settings settings = defaults(*in_.variable(chain.source));
    for (const Edge* edge : chain.edges)
      for (const auto& [key, value] : edge->settings) check_key(key, edge->line), settings[key] = value;
    for (const auto& [key, value] : settings) put(line, key, toml_value(value));
  }

  void check_key(const std::string& key, int line) const {
    const std::vector<std::string> known = {"reconstruction", "memory", "delay"};
    if (std::find(known.begin(), known.end(), key) == known.end())
      refuse(line, unknown("attribute of a connection", printable(key, 100), known));
  }

  /// Held outputs are held, and a scheme that chooses chooses.
  Settings defaults(const fmi::Variable& source) const {
    const auto stated = in_.settings.find("reconstruction");
    const auto scheme = in_.settings.find("scheme");
    if (source.variability != fmi::Variability::continuous) return {};
    if (stated != in_.settings.end()) return {{"reconstruction", stated->second}};
    if (scheme != in_.settings.end() && scheme->second == "auto") return {};
    return {{"reconstruction", "lagrange1"}};
  }

  void write_coordination(int line) {
    add(line, "[coordination]");
    for (const auto& [key, value] : in_.settings)
      if (key != "reconstruction") put(line, key, toml_value(value));
    if (in_.settings.empty()) put(line, "schedule", "\"slowest-first\"");
    if (in_.settings.empty() && !in_.edges.empty())
      to_.remarks.emplace_back(
          "the system says nothing of its coupling (annotation org.tandem.coordination): it is coupled "
          "slowest-first with lagrange1");
  }

  Structure in_;
  ScenarioText to_;
  std::map<int, std::string> names_;  ///< of components, by element
  std::set<std::string> taken_;
};

}  // namespace

ScenarioText scenario_text(const std::filesystem::path& file) { return Writer(read_structure(file)).write(); }

}  // namespace tandem::ssp
