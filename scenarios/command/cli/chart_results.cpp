// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/chart_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tandem/charts/csv_table.hpp"
#include "tandem/error.hpp"
#include "tandem/nearest.hpp"
#include "tandem/output/files.hpp"
#include "tandem/output/json.hpp"
#include "tandem/text/time_table.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

/// The rows of one of them that have a value.
std::string rows_of(const fs::path& results, const std::vector<std::string>& columns) {
  const auto table = text::TimeTable::read(results);
  std::vector<const std::vector<double>*> values;
  for (const std::string& column : columns) {
    const auto it = std::find(table.names.begin(), table.names.end(), column);
    if (it == table.names.end())
      throw Error(ErrorCode::invalid_argument,
                  results.string() + ": " + unknown("column", column, table.names));
    values.push_back(&table.columns[static_cast<std::size_t>(it - table.names.begin())]);
  }
  std::string rows;
  for (std::size_t k = 0; k < table.times.size(); ++k) {
    rows += charts::csv_cell(results.string()) + fmt::format(",{}", table.times[k]);
    for (const auto* column : values)
      rows += std::isnan((*column)[k]) ? "," : fmt::format(",{}", (*column)[k]);
    rows += '\n';
  }
  return rows;
}

/// What the first of the results says of units, and of what made it.
nlohmann::json about(const fs::path& results) {
  const fs::path file = results / "results.json";
  if (!fs::is_regular_file(file)) return nlohmann::json::object();
  const auto json = output::read_json(file);
  return {{"units", json.value("units", nlohmann::json::object())},
          {"made", json.value("versions", nlohmann::json::object())}};
}

}  // namespace

charts::Drawing plotted(const std::vector<fs::path>& results, const std::vector<std::string>& columns,
                        const fs::path& folder) {
  std::string text = "results,time";
  for (const std::string& column : columns) text += ',' + charts::csv_cell(column);
  text += '\n';
  for (const fs::path& one : results) text += rows_of(one, columns);
  output::make_folder(folder);
  output::replace_text(folder / "plot.csv", text);
  output::replace_text(folder / "plot.json", about(results.front()).dump(2) + '\n');
  charts::Chart chart;
  chart.name = chart.table = "plot";
  chart.kind = charts::Chart::Kind::traces;
  chart.series = {"results"};
  for (const std::string& column : columns)
    chart.y.push_back({{column, {}}}), chart.x.push_back({"time", {}});
  return charts::draw({{chart}, {}}, folder, "");
}

}  // namespace tandem::cli
