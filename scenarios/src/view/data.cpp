// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "view/data.hpp"

#include <algorithm>
#include <set>

#include "output/conditions.hpp"
#include "view/base64.hpp"
#include "view/drawing.hpp"
#include "view/plots.hpp"

namespace tandem::view {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::vector<double> picked(const std::vector<double>& values, const std::vector<std::size_t>& rows) {
  std::vector<double> some;
  some.reserve(rows.size());
  for (const std::size_t row : rows) some.push_back(values[row]);
  return some;
}

Json column(const Run& run, const std::string& name, const std::vector<double>& values) {
  Json json{{"name", name}, {"unit", run.unit(name)}};
  if (drawn_only(run, name)) {
    json["position"] = true;
    json["f4"] = base64(std::vector<float>(values.begin(), values.end()));
  } else {
    json["f8"] = base64(values);
  }
  return json;
}

Json table(const Run& run, const text::TimeTable& from, int every) {
  const auto rows = kept(from.times.size(), every);
  Json columns = Json::array();
  for (std::size_t k = 0; k < from.names.size(); ++k)
    if (!stands_still(run, from.names[k]))
      columns.push_back(column(run, from.names[k], picked(from.columns[k], rows)));
  return {{"rows", rows.size()},
          {"left_out", from.times.size() - rows.size()},
          {"time", base64(picked(from.times, rows))},
          {"columns", columns}};
}

/// How a run was made, for its reader.
Json details(const Run& run) {
  Json all = Json::object();
  if (run.about.contains("scenario")) {
    all["scenario"] = run.about["scenario"].value("file", "");
    if (const auto& set = run.about["scenario"]["overrides"]; !set.empty()) all["set"] = set;
  }
  if (run.about.contains("coordination")) all["schedule"] = run.about["coordination"].value("schedule", "");
  if (run.about.contains("notes") && !run.about["notes"].empty()) all["notes"] = run.about["notes"];
  if (run.about.contains("versions")) all["versions"] = run.about["versions"];
  return all;
}

Json result(const Run& run, const std::string& label, int every) {
  Json tables = Json::array(), mechanisms = Json::array();
  for (const text::TimeTable& one : run.tables) tables.push_back(table(run, one, every));
  for (const RunMechanism& mechanism : run.mechanisms) {
    Json drawn = drawing(mechanism.description, mechanism.view);
    drawn["instance"] = mechanism.instance;
    mechanisms.push_back(drawn);
  }
  return {{"label", label},
          {"status", run.about.value("status", "")},
          {"message", run.about.value("message", "")},
          {"details", details(run)},
          {"tables", tables},
          {"mechanisms", mechanisms}};
}

/// Names of the folders, or their whole paths where these are the same.
std::vector<std::string> labels(const std::vector<Run>& runs) {
  std::vector<std::string> names;
  std::set<std::string> seen;
  for (const Run& run : runs) {
    const fs::path place = run.place.lexically_normal();
    names.push_back((place.has_filename() ? place : place.parent_path()).filename().string());
    seen.insert(names.back());
  }
  if (seen.size() < names.size())
    for (std::size_t k = 0; k < runs.size(); ++k) names[k] = runs[k].place.string();
  return names;
}

}  // namespace

std::vector<std::size_t> kept(std::size_t rows, int every) {
  std::vector<std::size_t> all;
  for (std::size_t k = 0; k < rows; k += static_cast<std::size_t>(every)) all.push_back(k);
  if (rows > 0 && all.back() != rows - 1) all.push_back(rows - 1);
  return all;
}

Json data_of(const Content& content) {
  const Run& first = content.runs[0];
  const auto names = labels(content.runs);
  Json scenario = first.about.value("scenario", Json::object());
  Json results = Json::array();
  for (std::size_t k = 0; k < content.runs.size(); ++k)
    results.push_back(result(content.runs[k], names[k], content.every));
  return {{"title", scenario.value("name", names[0])},
          {"description", scenario.value("values", Json::object()).value("description", "")},
          {"tandem", std::string(TANDEM_VERSION) + " (" + output::source_commit() + ")"},
          {"notes", content.notes},
          {"plots", plots_at_first(first)},
          {"results", results}};
}

}  // namespace tandem::view
