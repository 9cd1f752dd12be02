// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "view/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "sources/elements.hpp"
#include "tandem/error.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/scenario/about.hpp"
#include "tandem/scenario/scenario.hpp"
#include "tandem/text/file_parameters.hpp"
#include "tandem/transports/open.hpp"
#include "tandem/transports/source_uri.hpp"

namespace tandem::view {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& sentence, ErrorCode code = ErrorCode::input_output) {
  throw Error(code, sentence);
}

struct RunSource {
  std::string instance, uri;
};

/// Of each subsystem; a mechanism that ran alone is its own source.
std::vector<RunSource> sources(const nlohmann::json& values, const fs::path& file) {
  std::vector<RunSource> all;
  if (values.contains("dimension"))
    all.push_back({file.stem().string(), "mechanism:" + file.filename().string()});
  if (values.contains("subsystems"))
    for (const auto& [name, entry] : values["subsystems"].items())
      all.push_back({name, entry.value("source", "")});
  return all;
}

/// A value that is an expression, as the scenario of these results has it.
std::optional<text::FileValue> computed(const RunSource& source, const std::string& name,
                                        const nlohmann::json& of_run) {
  const auto scenario =
      scenario::read(of_run.value("file", ""), of_run.value("overrides", std::vector<std::string>()));
  for (const auto& entry : scenario.subsystems)
    for (const auto& p : entry.parameters) {
      if (entry.name != source.instance || p.name != name) continue;
      if (const auto* number = std::get_if<double>(&p.value)) return *number;
      if (const auto* text = std::get_if<std::string>(&p.value)) return *text;
    }
  return std::nullopt;
}

/// What the run gave to a mechanism: in its URI, in the scenario's tables of parameters, or in the table [run]
/// of its file.
std::optional<text::FileValue> value_of(const RunSource& source, Parameters& of_uri,
                                        const text::FileParameter& parameter, const nlohmann::json& of_run) {
  const std::string& name = parameter.name;
  if (of_uri.has(name))
    return std::holds_alternative<double>(parameter.value) ? text::FileValue(of_uri.number(name, 0.0))
                                                           : text::FileValue(of_uri.text(name, ""));
  const nlohmann::json& values = of_run["values"];
  const nlohmann::json subsystems = values.value("subsystems", nlohmann::json::object());
  const nlohmann::json own = subsystems.value(source.instance, nlohmann::json::object());
  for (const auto& table :
       {own.value("parameters", nlohmann::json::object()),
        values.value(subsystems.empty() ? "run" : "parameters", nlohmann::json::object())})
    if (const auto it = table.find(name); it != table.end()) {
      if (it->is_number()) return it->get<double>();
      if (!it->is_string()) continue;
      const auto text = it->get<std::string>();
      if (text.starts_with("$") && !text.starts_with("$$")) return computed(source, name, of_run);
      return text::Values::literal(text);
    }
  return std::nullopt;
}

RunMechanism read_mechanism(const RunSource& source, const fs::path& folder, const fs::path& results,
                            const nlohmann::json& of_run) {
  const fs::path file = folder / SourceUri(source.uri).place;
  if (!fs::exists(file))
    refuse(
        fmt::format("file '{}' of the mechanism '{}', which {} names, is not there; run 'tandem view' in "
                    "the folder where 'tandem run' was run, or say --plots-only",
                    file.string(), source.instance, (results / "results.json").string()));
  const text::Document document(file);
  Parameters of_uri = query_of(source.uri);
  const auto given = text::given_values(
      document, [&](const text::FileParameter& p) { return value_of(source, of_uri, p, of_run); });
  RunMechanism mechanism{source.instance, file, mbs::read_mechanism(document, element_kinds(), given), {}};
  mechanism.view = read_view(document, mechanism.description);
  return mechanism;
}

/// A browser lists them all beside each plot.
void check_columns(const text::TimeTable& table) {
  constexpr std::size_t most = 100'000;
  if (table.names.size() > most)
    refuse(fmt::format("file '{}' has {} columns; a page can show up to {}", table.file.string(),
                       table.names.size(), most),
           ErrorCode::invalid_argument);
}

/// Names of subsystems in the order in which the results have them first.
std::unordered_map<std::string, std::size_t> order_of(const Run& run) {
  std::unordered_map<std::string, std::size_t> order;
  for (const text::TimeTable& table : run.tables)
    for (const std::string& column : table.names)
      order.emplace(column.substr(0, column.find('.')), order.size());
  return order;
}

/// Whether it is a run of a mechanism's file, not of a scenario.
bool alone(const Run& run) { return run.about.at("scenario").at("values").contains("dimension"); }

}  // namespace

std::string Run::unit(const std::string& column) const {
  const auto units = about.find("units");
  return units == about.end() ? "" : units->value(column, "");
}

bool Run::held(const std::string& column) const {
  const auto how = about.find("interpolation");
  return how != about.end() && how->value(column, "") == "held";
}

Run read_run(const fs::path& place) {
  Run run{place, nlohmann::json::object(), {}, {}, {}};
  if (!fs::exists(place))
    refuse(fmt::format("'{}' is not there; allowed is the folder of a run, or a CSV file", place.string()));
  if (!fs::is_directory(place)) {
    run.tables.push_back(text::TimeTable::read(place));
  } else {
    run.about = scenario::read_about(place);
    for (const auto& file : run.about["files"])
      run.tables.push_back(text::TimeTable::read(place / file.get<std::string>()));
    if ((run.indicators = scenario::largest_indicators(run.about, place)); !run.indicators.empty())
      run.tables.push_back(text::TimeTable::read(place / "indicators.csv"));
  }
  for (const text::TimeTable& table : run.tables) check_columns(table);
  for (const text::TimeTable& table : run.tables) run.columns.insert(table.names.begin(), table.names.end());
  return run;
}

void read_mechanisms(Run& run) {
  if (!run.about.contains("scenario")) return;
  const nlohmann::json& scenario = run.about["scenario"];  // with values: read_about()
  const fs::path file = scenario.value("file", "");
  for (const RunSource& source : sources(scenario["values"], file))
    if (SourceUri(source.uri).scheme == "mechanism")
      run.mechanisms.push_back(read_mechanism(source, file.parent_path(), run.place, scenario));
  const auto order = order_of(run);
  const auto place = [&](const RunMechanism& mechanism) {
    const auto it = order.find(mechanism.instance);
    return it == order.end() ? order.size() : it->second;
  };
  std::stable_sort(run.mechanisms.begin(), run.mechanisms.end(),
                   [&](const RunMechanism& a, const RunMechanism& b) { return place(a) < place(b); });
}

void check_positions(const Run& run) {
  for (const RunMechanism& mechanism : run.mechanisms)
    for (const mbs::Entity& entity : mechanism.description.entities) {
      const std::string column = mechanism.instance + "." + entity.name + ".x";
      if (entity.fixed || run.has(column)) continue;
      refuse(fmt::format("{} has no column {}, so where the mechanism '{}' is can't be drawn; run it again "
                         "with --set {}.animate=true, or say --plots-only",
                         run.place.string(), column, mechanism.instance, alone(run) ? "run" : "record"),
             ErrorCode::invalid_argument);
    }
}

}  // namespace tandem::view
