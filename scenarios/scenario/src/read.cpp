// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <set>

#include "read_constants.hpp"
#include "read_link.hpp"
#include "read_parameters.hpp"
#include "settings.hpp"
#include "tandem/scenario/document_of.hpp"
#include "tandem/scenario/keys.hpp"
#include "tandem/scenario/scenario_file.hpp"
#include "tandem/text/file_parameters.hpp"
#include "tandem/text/section.hpp"
#include "tandem/text/series.hpp"
#include "to_json.hpp"

namespace tandem::scenario {
namespace {

using Json = nlohmann::ordered_json;
using text::Document;
using text::in_file_order;
using text::number_of;

/// Fills a Scenario, table by table.
class Reader {
 public:
  Reader(const Document& document, Scenario& scenario) : document_(document), to_(scenario) {}

  void read() {
    if (document_.table().empty())
      refuse(
          Place{to_.file.string()},
          "the file holds nothing; allowed is a scenario, with tables [subsystems.NAME], a mechanism, with "
          "points, or a diagram, with blocks");
    Section root(document_, keys(), &constants_);
    const auto named = named_constants(document_);
    to_.constants = read_constants(root, constants_);
    std::erase_if(to_.constants, [&](const auto& constant) { return !named.contains(constant.first); });
    to_.name = root.text("name").value_or(to_.file.stem().string());
    to_.description = root.text("description").value_or("");
    if (const auto* table = root.table("parameters")) shared_ = parameters(*table, "parameters", &constants_);
    read_subsystems(root);
    for (Section& connection : root.sections("connections")) read_connection(connection);
    for (Section& link : root.sections("links")) to_.links.push_back(read_link(link));
    for (const auto& [name, read_into] : settings())
      if (auto section = root.section(name)) read_into(*section, to_);
    root.table("study");  // who sweeps reads it
    if (!root.node("span")) root.missing("span", "a table [span] with start and stop in s");
    root.refuse_unknown();
  }

  /// A mechanism or a diagram alone: its file is the source, its table [run] says how long and how.
  void read_alone(const std::string& kind, const std::vector<std::string>& overrides) {
    Section root(document_, document_.table(), "");
    to_.name = root.text("name").value_or(to_.file.stem().string());
    to_.description = root.text("description").value_or("");
    const toml::table* table = root.table("run");
    if (!table) root.missing("run", "a table [run] with stop and step in s, to run the " + kind + " alone");
    SubsystemEntry entry{
        to_.file.stem().string(), kind + ":" + to_.file.filename().string(), {}, {}, document_.place(*table),
        document_.place(*table)};
    entry.overrides = overrides;
    const text::Values values = text::values_in_run(document_, [](const auto&) { return std::nullopt; });
    Section run = Section(document_, *table, "run").with(values);
    read_span(run);
    for (Parameter& p : parameters(*table, "run", &values, kind == "diagram" ? "inputs" : ""))
      if (p.name != "start" && p.name != "stop")
        entry.parameters.push_back(with_own_value(std::move(p), values));
    if (kind == "diagram") read_inputs_of_diagram(run, values, entry);
    to_.animate = kind == "mechanism" && !run.node("animate");
    to_.subsystems.push_back(std::move(entry));
  }

 private:
  /// A parameter of the file that refers has its value already.
  static Parameter with_own_value(Parameter p, const text::Values& values) {
    const text::FileValue* const own = p.refers ? values.find(p.name) : nullptr;
    if (!own) return p;
    if (const auto* number = std::get_if<double>(own))
      p.value = *number;
    else
      p.value = std::get<std::string>(*own);
    return p;
  }

  void read_span(Section& run) {
    const auto start = run.number("start"), step = run.number("step"), stop = run.number("stop");
    if (!stop) run.missing("stop", "the time of its end [s]");
    to_.start = start.value_or(0.0);
    to_.stop = *stop;
    if (to_.stop <= to_.start) run.wrong("stop", described(*run.node("stop")), "a time in s after run.start");
    if (step && *step > to_.stop - to_.start)
      run.wrong("step", described(*run.node("step")),
                fmt::format("up to {} s, the time from run.start to run.stop", to_.stop - to_.start));
  }

  /// They are what those of a subsystem are.
  void read_inputs_of_diagram(Section& run, const text::Values& values, SubsystemEntry& entry) const {
    if (const toml::table* table = run.table("inputs")) {
      Section inputs =
          Section(document_, keys(), *table, run.name("inputs"), "subsystems.NAME.inputs").with(values);
      read_inputs(inputs, entry);
    }
  }

  std::vector<Parameter> parameters(const toml::table& table, const std::string& path,
                                    const text::Values* constants, const std::string& but = "") const {
    return read_parameters(document_, table, path, constants, but);
  }

  void read_subsystems(Section& root) {
    auto all = root.section("subsystems");
    if (!all || all->table().empty())
      root.missing(
          "subsystems",
          "a table [subsystems.NAME] for each; a mechanism has points, a diagram blocks, a study tables");
    for (auto& [name, section] : all->named_sections()) read_subsystem(name, section);
  }

  void read_subsystem(const std::string& name, Section& section) {
    SubsystemEntry entry{name, "", shared_, {}, section.place(), section.place("source")};
    if (section.node("command"))
      read_command(section, entry);
    else
      entry.source = section.required_text(
          "source", "a source like \"builtin:NAME\", or command, a program and its arguments");
    if (const auto* table = section.table("parameters"))
      for (Parameter& own : parameters(*table, section.name("parameters"), &constants_)) {
        std::erase_if(entry.parameters, [&](const Parameter& p) { return p.name == own.name; });
        own.key = section.name("parameters") + "." + own.key;
        entry.parameters.push_back(std::move(own));
      }
    if (auto inputs = section.section("inputs")) read_inputs(*inputs, entry);
    entry.isolated = *section.flag("isolate");
    if (entry.isolated && !entry.command.empty())
      section.leave_out("isolate", "a command is a process of its own");
    if (section.node("land")) to_.coordination.landing[name] = landing(*section.text("land"));
    section.refuse_unknown();
    to_.subsystems.push_back(std::move(entry));
  }

  void read_command(Section& section, SubsystemEntry& entry) const {
    const std::string allowed = "an array of texts, a program and its arguments";
    if (section.node("source")) section.wrong("command", "given beside source", "one of them");
    if (!section.node("command")->is_array())
      section.wrong("command", described(*section.node("command")), allowed);
    entry.command = section.texts("command");
    if (entry.command.empty()) section.wrong("command", "empty", allowed);
    entry.source = "spawn:";
    entry.source_place = section.place("command");
  }

  void read_inputs(Section& inputs, SubsystemEntry& entry) const {
    for (const auto& [port, node] : in_file_order(inputs.table()))
      if (node->is_table())
        read_series(inputs.of_name(port), port, entry);
      else
        read_numbers(inputs, *node, port, entry);
    refuse_twice(inputs, entry);
  }

  /// A port as a whole and an element of it, say.
  static void refuse_twice(const Section& inputs, const SubsystemEntry& entry) {
    std::set<std::string> names, wholes, in_parts;
    for (const InputEntry& one : entry.inputs) {
      const std::string port = one.port.substr(0, one.port.find('['));
      const bool is_whole = port == one.port;
      if (!names.insert(one.port).second || wholes.contains(port) || (is_whole && in_parts.contains(port)))
        refuse(one.place, inputs.name(one.port) + " is given twice; allowed is one value for each input");
      (is_whole ? wholes : in_parts).insert(port);
    }
  }

  void read_series(Section section, const std::string& port, SubsystemEntry& entry) const {
    const auto series = text::read_series(section, to_.file.parent_path());
    if (!series) section.missing("file", "file and column, or times and values");
    section.refuse_unknown();
    entry.inputs.push_back({port, std::make_shared<const TimeSeries>(*series), section.place()});
  }

  void read_numbers(const Section& inputs, const toml::node& node, const std::string& port,
                    SubsystemEntry& entry) const {
    const auto add = [&](const toml::node& value, const std::string& index) {
      const std::string path = inputs.name(port) + index;
      entry.inputs.push_back({port + index, inputs.number_of(value, path), document_.place(value)});
    };
    if (!node.is_array()) return add(node, "");
    int element = 0;
    for (const toml::node& value : *node.as_array()) add(value, "[" + std::to_string(element++) + "]");
  }

  void read_connection(Section& section) {
    Connection c{section.required_text("from"), section.required_text("to"), {}};
    if (const auto how = section.text("reconstruction")) c.how = Reconstruction::parse(*how);
    c.gain = *section.number("gain");
    c.offset = *section.number("offset");
    c.add = *section.flag("add");
    c.convert = *section.flag("convert");
    const bool memory = *section.flag("memory"), delay = *section.flag("delay");
    if (memory && delay) section.wrong("delay", "true beside memory = true", "one of them");
    c.lag = memory ? Lag::memory : delay ? Lag::delay : Lag::none;
    section.refuse_unknown();
    to_.connections.push_back({std::move(c), section.place(), section.place("from"), section.place("to"),
                               section.place("reconstruction")});
  }

  const Document& document_;
  Scenario& to_;
  text::Values constants_;
  std::vector<Parameter> shared_;
};

std::string kind_of(const toml::table& table) {
  for (const char* key : {"dimension", "points", "vectors", "bodies", "rods", "coordinates"})
    if (table.contains(key)) return "mechanism";
  return table.contains("blocks") ? "diagram" : "";
}

}  // namespace

std::string kind_alone(const std::filesystem::path& file) { return kind_of(document_of(file).table()); }

namespace {

Scenario scenario_of(const Document& document, const std::vector<std::string>& overrides) {
  const std::string alone = kind_of(document.table());
  Scenario scenario;
  scenario.file = document.file();
  Reader reader(document, scenario);
  alone.empty() ? reader.read() : reader.read_alone(alone, overrides);
  if (scenario.indicators == Indication::estimate && !scenario.judge)
    refuse(scenario.place("record.indicators"),
           "record.indicators is estimate, of the output that [judge] names, and there is no [judge]; "
           "allowed are raw "
           "and off");
  scenario.overrides = overrides;
  scenario.values = to_json(document.table()).dump(-1, ' ', false, Json::error_handler_t::replace);
  return scenario;
}

}  // namespace

Scenario read(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  return ScenarioFile(file, overrides).with({});
}

/// A document whose values were set once takes others for the same keys; copies of one would not know their
/// lines.
class ScenarioFile::Parsed {
 public:
  Parsed(std::filesystem::path file, std::vector<std::string> overrides)
      : file_(std::move(file)), text_(file_text(file_)), overrides_(std::move(overrides)) {
    document({});
  }

  Scenario with(const std::vector<Setting>& settings) {
    const std::lock_guard lock(mutex_);
    Document& of_keys = document(settings);
    std::vector<std::string> overrides = overrides_;
    for (const Setting& setting : settings) {
      of_keys.set(setting.key, setting.value);
      overrides.push_back(text::override_of(setting.key, setting.value));
    }
    Scenario scenario = scenario_of(of_keys, overrides);
    scenario.remarks.insert(scenario.remarks.begin(), text_.remarks.begin(), text_.remarks.end());
    return scenario;
  }

 private:
  Document& document(const std::vector<Setting>& settings) {
    std::vector<std::string> keys;
    for (const Setting& setting : settings) keys.push_back(setting.key);
    const auto it = documents_.find(keys);
    if (it != documents_.end()) return it->second;
    Document made(file_.string(), text_.text, text_.lines);
    made.set(overrides_);
    return documents_.emplace(std::move(keys), std::move(made)).first->second;
  }

  std::filesystem::path file_;
  FileText text_;
  std::vector<std::string> overrides_;
  std::mutex mutex_;
  std::map<std::vector<std::string>, Document> documents_;  ///< by the keys that are set
};

ScenarioFile::ScenarioFile(std::filesystem::path file, std::vector<std::string> overrides)
    : parsed_(std::make_unique<Parsed>(std::move(file), std::move(overrides))) {}
ScenarioFile::~ScenarioFile() = default;
Scenario ScenarioFile::with(const std::vector<Setting>& settings) const { return parsed_->with(settings); }

}  // namespace tandem::scenario
