// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/charts/draw.hpp"

#include "drawings.hpp"

namespace tandem::charts {
namespace {

using text::located;

/// The tables of a folder, or else of that of the charts, each read once.
class Tables {
 public:
  Tables(std::filesystem::path folder, const std::filesystem::path& beside)
      : folder_(std::move(folder)), beside_(beside) {}
  const Table& of(const std::string& name, const text::Place& place) {
    const auto it = tables_.find(name);
    if (it != tables_.end()) return it->second;
    const auto lies_in = [&](const auto& folder) {
      return std::filesystem::exists(folder / (name + ".csv"));
    };
    const auto& folder = !lies_in(folder_) && lies_in(beside_) ? beside_ : folder_;
    return located(place,
                   [&]() -> const Table& { return tables_.try_emplace(name, folder, name).first->second; });
  }

 private:
  std::filesystem::path folder_, beside_;
  std::map<std::string, Table> tables_;
};

}  // namespace

Drawing draw(const Charts& charts, const std::filesystem::path& folder, const std::string& only_table) {
  Tables tables(folder, charts.beside);
  Drawing drawing;
  for (const Chart& chart : charts.all) {
    const std::string& name = chart.table.empty() ? only_table : chart.table;
    if (name.empty())
      refuse(chart.place, "charts: " + chart.name + " names no table; allowed is table = \"TABLE\"");
    const Table& table = tables.of(name, chart.place);
    const Table* overlay = chart.overlay ? &tables.of(chart.overlay->table, chart.place) : nullptr;
    Charts own{{}, chart.names, {}};
    own.names.insert(charts.names.begin(), charts.names.end());
    if (chart.kind == Chart::Kind::table) {
      drawing.sheets.push_back({chart.name + ".md", markdown_table(chart, own, table)});
      continue;
    }
    drawing.pictures.push_back(chart.kind == Chart::Kind::map ? draw_map(chart, own, table, drawing.words)
                               : chart.kind == Chart::Kind::traces ? draw_traces(chart, own, table)
                                                                   : draw_points(chart, own, table, overlay));
  }
  return drawing;
}

}  // namespace tandem::charts
