// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/chart_results.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tandem/charts/csv_table.hpp"
#include "tandem/error.hpp"
#include "tandem/nearest.hpp"
#include "tandem/output/files.hpp"
#include "tandem/output/json.hpp"
#include "tandem/scenario/about.hpp"
#include "tandem/text/time_table.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

const std::vector<double>* find(const text::TimeTable& table, const std::string& column) {
  const auto it = std::find(table.names.begin(), table.names.end(), column);
  return it == table.names.end() ? nullptr
                                 : &table.columns[static_cast<std::size_t>(it - table.names.begin())];
}

/// What a table has of these columns.
std::string rows_of(const text::TimeTable& table, const std::string& results,
                    const std::vector<std::string>& columns) {
  std::vector<const std::vector<double>*> values;
  for (const std::string& column : columns) values.push_back(find(table, column));
  std::string rows;
  for (std::size_t k = 0; k < table.times.size(); ++k) {
    rows += charts::csv_cell(results) + fmt::format(",{}", table.times[k]);
    for (const auto* column : values)
      rows += !column || std::isnan((*column)[k]) ? "," : fmt::format(",{}", (*column)[k]);
    rows += '\n';
  }
  return rows;
}

text::TimeTable with_all(const fs::path& results, const std::vector<std::string>& columns) {
  auto table = text::TimeTable::read(results);
  for (const std::string& column : columns)
    if (!find(table, column))
      throw Error(ErrorCode::invalid_argument,
                  results.string() + ": " + unknown("column", column, table.names));
  return table;
}

/// What stands under the curves.
std::vector<std::string> indicators_of(const fs::path& results) {
  if (!fs::is_regular_file(results / "results.json")) return {};
  return scenario::largest_indicators(scenario::read_about(results), results);
}

/// What the first of the results says of units, and of what made it.
nlohmann::json about(const fs::path& results) {
  const fs::path file = results / "results.json";
  if (!fs::is_regular_file(file)) return nlohmann::json::object();
  const auto json = output::read_json(file);
  return {{"units", json.value("units", nlohmann::json::object())},
          {"made", json.value("versions", nlohmann::json::object())}};
}

/// The name of a link is longer than an axis.
std::map<std::string, std::string> short_names(const std::vector<std::string>& columns) {
  std::map<std::string, std::string> names;
  for (const std::string& column : columns)
    if (column.starts_with("energy(")) names[column] = "energy made [J]";
  return names;
}

}  // namespace

charts::Drawing plotted(const std::vector<fs::path>& results, const std::vector<std::string>& columns,
                        const fs::path& folder) {
  std::vector<std::string> all = columns;
  for (const std::string& name : indicators_of(results.front())) all.push_back(name);
  std::string text = "results,time";
  for (const std::string& column : all) text += ',' + charts::csv_cell(column);
  text += '\n';
  charts::Chart chart;
  for (const fs::path& one : results) {
    if (const std::string what = scenario::unfinished(one); !what.empty())
      spdlog::warn("note: {}", chart.notes.emplace_back(what));
    text += rows_of(with_all(one, columns), one.string(), all);
    if (all.size() > columns.size() && fs::is_regular_file(one / "indicators.csv"))
      text += rows_of(text::TimeTable::read(one / "indicators.csv"), one.string(), all);
  }
  output::make_folder(folder);
  output::replace_text(folder / "plot.csv", text);
  output::replace_text(folder / "plot.json", about(results.front()).dump(2) + '\n');
  chart.name = chart.table = "plot";
  chart.kind = charts::Chart::Kind::traces;
  chart.series = {"results"};
  for (const std::string& column : all) chart.y.push_back({{column, {}}}), chart.x.push_back({"time", {}});
  return charts::draw({{chart}, short_names(all)}, folder, "");
}

}  // namespace tandem::cli
