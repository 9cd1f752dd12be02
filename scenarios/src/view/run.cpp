// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "view/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "sources/elements.hpp"
#include "tandem/error.hpp"
#include "tandem/mbs/mechanism/read.hpp"

namespace tandem::view {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

[[noreturn]] void refuse(const std::string& sentence, ErrorCode code = ErrorCode::input_output) {
  throw Error(code, sentence);
}

Json read_about(const fs::path& folder) {
  const fs::path file = folder / "results.json";
  std::ifstream in(file);
  if (!in) refuse(fmt::format("file '{}' is missing; 'tandem run' writes it", file.string()));
  Json json = Json::parse(in, nullptr, false);
  if (!json.is_object() || !json.contains("files") || !json.contains("scenario"))
    refuse(fmt::format("file '{}' is not one of a run", file.string()));
  return json;
}

/// Name and source of each subsystem; a mechanism that ran alone is its own source.
std::vector<std::pair<std::string, std::string>> sources(const Json& values, const fs::path& file) {
  std::vector<std::pair<std::string, std::string>> all;
  if (values.contains("dimension"))
    all.emplace_back(file.stem().string(), "mechanism:" + file.filename().string());
  if (values.contains("subsystems"))
    for (const auto& [name, entry] : values["subsystems"].items())
      all.emplace_back(name, entry.value("source", ""));
  return all;
}

RunMechanism read_mechanism(const std::string& instance, const fs::path& file, const fs::path& results) {
  if (!fs::exists(file))
    refuse(
        fmt::format("file '{}' of the mechanism '{}', which {} names, is not there; run 'tandem view' in "
                    "the folder where 'tandem run' was run, or say --plots-only",
                    file.string(), instance, (results / "results.json").string()));
  RunMechanism mechanism{instance, file, mbs::read_mechanism(file, element_kinds()), {}};
  mechanism.view = mechanisms::read_view(text::Document(file), mechanism.description);
  return mechanism;
}

/// Whether it is a run of a mechanism's file, not of a scenario.
bool alone(const Run& run) { return run.about["scenario"]["values"].contains("dimension"); }

}  // namespace

std::string Run::unit(const std::string& column) const {
  return about.contains("units") ? about["units"].value(column, "") : "";
}

bool Run::has(const std::string& column) const {
  return std::any_of(tables.begin(), tables.end(), [&](const text::TimeTable& table) {
    return std::find(table.names.begin(), table.names.end(), column) != table.names.end();
  });
}

Run read_run(const fs::path& place) {
  Run run{place, Json::object(), {}, {}};
  if (!fs::exists(place))
    refuse(fmt::format("'{}' is not there; allowed is the folder of a run, or a CSV file", place.string()));
  if (!fs::is_directory(place)) {
    run.tables.push_back(text::TimeTable::read(place));
    return run;
  }
  run.about = read_about(place);
  for (const auto& file : run.about["files"])
    run.tables.push_back(text::TimeTable::read(place / file.get<std::string>()));
  return run;
}

void read_mechanisms(Run& run) {
  if (!run.about.contains("scenario")) return;
  const Json& scenario = run.about["scenario"];
  const fs::path file = scenario.value("file", "");
  constexpr std::string_view scheme = "mechanism:";
  for (const auto& [name, source] : sources(scenario["values"], file)) {
    if (!source.starts_with(scheme)) continue;
    const std::string path = source.substr(scheme.size(), source.find('?') - scheme.size());
    run.mechanisms.push_back(read_mechanism(name, file.parent_path() / path, run.place));
  }
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
