// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "chains.hpp"
#include "structure.hpp"
#include "tandem/error.hpp"
#include "tandem/nearest.hpp"
#include "tandem/printable.hpp"
#include "tandem/ssp/ssp.hpp"
#include "tandem/text/place.hpp"
#include "tandem/text/set.hpp"
#include "value_text.hpp"

namespace tandem::ssp {
namespace {

using text::toml_text;
using text::toml_value;

class Writer {
 public:
  explicit Writer(Structure structure) : in_(std::move(structure)) {
    for (int k = 0; k < static_cast<int>(in_.elements.size()); ++k)
      if (!in_.at(k).is_system()) names_[k] = instance_name(k);
    for (const Edge& edge : in_.edges) read_.insert(edge.from);
  }

  ScenarioText write() {
    const int line = in_.at(0).line;
    put(line, "name", literal(in_.name));
    if (!in_.description.empty()) put(line, "description", literal(in_.description));
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
    std::set<std::string> unused;
    for (const auto& [node, given] : in_.given)
      if (used_.count(given.order) == 0)
        unused.insert((node.first == 0 ? "" : in_.full_name(node.first) + ".") + printable(node.second, 100));
    if (!unused.empty())
      to_.remarks.push_back(
          fmt::format("{} values have no effect, as nothing reads them or another holds: {}{}", unused.size(),
                      *unused.begin(), unused.size() > 1 ? ", ..." : ""));
    to_.remarks.insert(to_.remarks.end(), in_.remarks.begin(), in_.remarks.end());
    if (!in_.undefined_units.empty())
      to_.remarks.push_back("units of connectors that are not defined are those of the FMUs: " +
                            listed({in_.undefined_units.begin(), in_.undefined_units.end()}));
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
    for (int& k = next_[name]; !taken_.insert(once).second;) once = name + "_" + std::to_string(k++ + 2);
    return once;
  }

  void write_component(int number, const std::string& name) {
    const Element& element = in_.at(number);
    const int line = element.line;
    add(line, "[subsystems." + toml_text(name) + "]");
    const auto folder = in_.file.parent_path().lexically_normal();
    put(line, "source", literal("fmu:" + element.file.lexically_proximate(folder).string()));
    if (element.implementation == "ModelExchange") put(line, "parameters.type", "\"me\"");
    if (element.implementation == "CoSimulation") put(line, "parameters.type", "\"cs\"");
    for (const auto& [key, value] : element.settings) {
      check_component_key(key, element);
      const bool of_subsystem = key == "land" || key == "isolate";
      put(line, of_subsystem ? key : "parameters." + toml_text(key), toml_value(value));
    }
    write_units(number);
    write_outputs(number);
    write_values(number);
  }

  /// Names of an element that are keys of a map by nodes.
  template <class Map>
  static void add_names(const Map& all, int number, std::set<std::string>& to) {
    for (auto it = all.lower_bound({number, ""}); it != all.end() && it->first.first == number; ++it)
      to.insert(it->first.second);
  }

  /// Of ports, where the FMU has others.
  void write_units(int number) {
    std::set<std::string> names;
    for (const auto& [name, connector] : in_.at(number).connectors) names.insert(name);
    add_names(in_.into, number, names);
    for (const std::string& name : names) {
      const fmi::Variable* v =
          in_.variable({number, name});  // null: of a connector that nothing is connected to
      const bool is_port = v && (v->causality == fmi::Causality::input ||
                                 v->causality == fmi::Causality::output || read_.count({number, name}) != 0);
      if (!is_port) continue;
      const std::string unit = keeps_numbers({number, name}) ? "" : in_.unit({number, name});
      if (unit == v->unit) continue;
      put(in_.at(number).line, "parameters.unit." + toml_text(name), toml_text(unit));
      if (!unit.empty() && !v->unit.empty())
        to_.remarks.push_back(fmt::format("'{}.{}' has the unit '{}' of the system; its FMU says '{}'",
                                          in_.full_name(number), printable(name, 100), printable(unit, 100),
                                          printable(v->unit, 100)));
    }
  }

  /// Whether it takes those of another component whatever the units are.
  bool keeps_numbers(const Node& node) {
    if (in_.into.count(node) == 0) return false;
    const Chain chain = chain_to(in_, node);
    return names_.count(chain.source.first) != 0 && gain_of(in_, chain).keeps_number;
  }

  /// Variables that others read and that the FMU does not call outputs.
  void write_outputs(int number) {
    if (in_.at(number).settings.count("outputs") != 0) return;  // it says which
    std::set<std::string> more;
    for (auto it = read_.lower_bound({number, ""}); it != read_.end() && it->first == number; ++it)
      if (in_.variable(*it)->causality != fmi::Causality::output) more.insert(toml_text(it->second));
    if (more.empty()) return;
    put(in_.at(number).line, "parameters.outputs", "[" + listed({more.begin(), more.end()}) + "]");
  }

  void write_values(int number) {
    std::set<std::string> names;
    add_names(in_.given, number, names), add_names(in_.into, number, names);
    for (const std::string& name : names) {
      const Node node{number, name};
      const Chain chain = chain_to(in_, node);
      const bool is_read = !chain.edges.empty() && names_.count(chain.source.first) != 0;
      const fmi::Variable& v = *in_.variable(node);
      if (is_read && v.causality != fmi::Causality::input)
        refuse(chain.line(),
               "parameter '" + printable(name, 200) + "' is to follow another component; allowed is a value");
      if (const auto given = given_through(in_, chain)) write_value(v, *given);
    }
  }

  void write_value(const fmi::Variable& v, const Given& given) {
    const bool is_input = v.causality == fmi::Causality::input && fmi::is_number(v.type);
    const std::string name = toml_text(is_input ? fmi::port_name(v.name) : v.name);
    put(given.line, (is_input ? "inputs." : "parameters.set.") + name,
        value_text(v, given, is_input, in_.file));
    used_.insert(given.order);
  }

  std::string port(const Node& node) const {
    return literal(names_.at(node.first) + "." + fmi::port_name(node.second));
  }

  void write_connection(const Node& to) {
    const Chain chain = chain_to(in_, to);
    if (names_.count(chain.source.first) == 0) return;  // a value, if there is one
    const Gain how = gain_of(in_, chain);
    const int line = chain.line();
    ++connections_;
    add(line, "[[connections]]");
    put(line, "from", port(chain.source)), put(line, "to", port(to));
    if (how.gain != 1.0) put(line, "gain", number(how.gain));
    if (how.offset != 0.0) put(line, "offset", number(how.offset));
    if (how.converts) put(line, "convert", "true");
    Settings settings = defaults(*in_.variable(chain.source));
    for (const Edge* edge : chain.edges)
      for (const auto& [key, value] : edge->settings) check_key(key, edge->line), settings[key] = value;
    for (const auto& [key, value] : settings) put(line, toml_text(key), toml_value(value));
  }

  /// What the standard has words for is not said again.
  void check_component_key(const std::string& key, const Element& element) const {
    const bool twice = key == "type" && element.implementation != "any";
    if (key == "set" || key == "unit" || twice)
      refuse(element.line, "annotation org.tandem.coordination: attribute '" + key +
                               "' says what a parameter binding, a connector or `implementation` does; "
                               "allowed are other parameters of an FMU, land and isolate");
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
      if (key != "reconstruction") put(line, toml_text(key), toml_value(value));
    if (in_.settings.empty()) put(line, "schedule", "\"slowest-first\"");
    if (in_.settings.empty() && connections_ > 0)
      to_.remarks.emplace_back(
          "the system says nothing of its coupling (annotation org.tandem.coordination): it is coupled "
          "slowest-first with lagrange1");
  }

  Structure in_;
  ScenarioText to_;
  std::map<int, std::string> names_;  ///< of components, by element
  std::set<std::string> taken_;
  std::map<std::string, int> next_;  ///< number behind a name that is taken, less 2
  std::set<Node> read_;              ///< that a connection begins at
  std::set<std::size_t> used_;       ///< values, by their order
  std::size_t connections_ = 0;
};

}  // namespace

ScenarioText scenario_text(const std::filesystem::path& file) {
  if (file.filename().string().find_first_of("?&") != std::string::npos)
    throw Error(
        ErrorCode::invalid_argument,
        "'" + file.string() + "' has ? or & in its name, which mean something else in a source; rename it");
  return Writer(read_structure(file)).write();
}

}  // namespace tandem::ssp
