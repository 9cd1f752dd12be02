// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "view/data.hpp"

#include <algorithm>
#include <set>

#include "tandem/output/provenance.hpp"
#include "view/base64.hpp"
#include "view/drawing.hpp"
#include "view/plots.hpp"

namespace tandem::view {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json column(const Run& run, const std::string& name, const std::vector<double>& values,
            const Thinning& thinning) {
  Json json{{"name", name}, {"unit", run.unit(name)}};
  if (run.held(name)) json["held"] = true;
  if (drawn_only(run, name)) {
    const auto kept = thinning.ends(values);
    json["position"] = true;
    json["f4"] = base64(std::vector<float>(kept.begin(), kept.end()));
  } else {
    json["f8"] = base64(thinning.bands(values));
  }
  return json;
}

Json table(const Run& run, const text::TimeTable& from, int every) {
  const Thinning thinning = thinning_of(from, every);
  Json columns = Json::array();
  for (std::size_t k = 0; k < from.names.size(); ++k)
    if (!stands_still(run, from.names[k]))
      columns.push_back(column(run, from.names[k], from.columns[k], thinning));
  return {{"rows", thinning.rows()},
          {"left_out", from.times.size() - thinning.rows()},
          {"time", base64(thinning.ends(from.times))},
          {"columns", columns}};
}

/// How a run was made, for its reader.
Json details(const Run& run) {
  Json all = Json::object();
  if (const auto scenario = run.about.find("scenario"); scenario != run.about.end()) {
    all["scenario"] = scenario->value("file", "");
    if (const auto set = scenario->find("overrides"); set != scenario->end() && !set->empty())
      all["set"] = *set;
  }
  if (const auto how = run.about.find("coordination"); how != run.about.end())
    all["schedule"] = how->value("schedule", "");
  if (const auto notes = run.about.find("notes"); notes != run.about.end() && !notes->empty())
    all["notes"] = *notes;
  if (const auto versions = run.about.find("versions"); versions != run.about.end())
    for (const char* of : {"tandem", "commit", "compiler"}) all["versions"][of] = versions->value(of, "");
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

Thinning thinning_of(const text::TimeTable& table, int every) {
  return {table.times.size(), table.names.size(), every};
}

Json data_of(const Content& content) {
  const Run& first = content.runs[0];
  const auto names = labels(content.runs);
  const auto scenario = first.about.value("scenario", nlohmann::json::object());
  Json results = Json::array();
  for (std::size_t k = 0; k < content.runs.size(); ++k)
    results.push_back(result(content.runs[k], names[k], content.every));
  return {{"title", scenario.value("name", names[0])},
          {"description", scenario.value("values", nlohmann::json::object()).value("description", "")},
          {"tandem", output::version() + " (" + output::source_commit() + ")"},
          {"notes", content.notes},
          {"plots", plots_at_first(first)},
          {"results", results}};
}

}  // namespace tandem::view
