// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/text/time_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <string_view>

#include "tandem/text/place.hpp"

namespace tandem::text {
namespace {

namespace fs = std::filesystem;
/// One line at a time into cells; a cell may be quoted, with "" for a quote in it.
class Lines {
 public:
  explicit Lines(const fs::path& file) : place_{file.string()}, in_(file, std::ios::binary) {
    if (!in_) refuse(place_, "the file can't be read", ErrorCode::input_output);
  }

  bool next(std::vector<std::string>& cells) {
    if (!std::getline(in_, line_)) return false;
    if (++place_.line == 1 && line_.starts_with("\xEF\xBB\xBF")) line_.erase(0, 3);  // UTF-8's mark
    if (line_.ends_with('\r')) line_.pop_back();
    cells.assign(1, {});
    bool quoted = false;
    char before = ',';
    for (const char c : line_) {
      if (c == '"') quoted = !quoted;
      const bool second_of_pair = c == '"' && before == '"' && quoted;
      if (c == ',' && !quoted)
        cells.emplace_back();
      else if (c != '"' || second_of_pair)
        cells.back() += c;
      before = c;
    }
    if (quoted) refuse(place_, "a quotation mark is not closed; allowed are pairs of them");
    return true;
  }
  const Place& place() const { return place_; }

 private:
  Place place_;
  std::ifstream in_;
  std::string line_;
};

double number(const std::string& cell, const std::string& column, const Place& place) {
  if (cell.empty()) refuse(place, "column " + column + " is empty; allowed is a finite number");
  double value = 0.0;
  const auto [end, code] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (code != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value))
    refuse(place, "column " + column + " holds '" + cell + "'; allowed is a finite number");
  return value;
}

void read_header(TimeTable& table, const std::vector<std::string>& cells, const Place& place) {
  if (cells[0] != "time") refuse(place, "the first column is '" + cells[0] + "'; allowed is time");
  table.names.assign(cells.begin() + 1, cells.end());
  table.columns.resize(table.names.size());
  for (const std::string& name : table.names)
    if (std::count(table.names.begin(), table.names.end(), name) > 1)
      refuse(place, "column " + name + " is there twice");
}

void read_row(TimeTable& table, const std::vector<std::string>& cells, const Place& place) {
  if (cells.size() != table.names.size() + 1)
    refuse(place, "the row has " + std::to_string(cells.size()) + " cells; the header has " +
                      std::to_string(table.names.size() + 1));
  const double time = number(cells[0], "time", place);
  if (!table.times.empty() && time < table.times.back())
    refuse(place, "time falls to " + cells[0] + " s; it must rise or stay");
  table.times.push_back(time);
  for (std::size_t k = 0; k < table.names.size(); ++k)
    table.columns[k].push_back(cells[k + 1].empty() ? std::numeric_limits<double>::quiet_NaN()
                                                    : number(cells[k + 1], table.names[k], place));
}

}  // namespace

TimeTable TimeTable::read(const fs::path& place) {
  TimeTable table;
  table.file = fs::is_directory(place) ? place / "results.csv" : place;
  if (!fs::exists(table.file))
    throw Error(ErrorCode::input_output, "file '" + table.file.string() + "' is not there");
  Lines lines(table.file);
  std::vector<std::string> cells;
  if (!lines.next(cells)) refuse(lines.place(), "the file is empty; a header row is missing");
  read_header(table, cells, lines.place());
  while (lines.next(cells)) read_row(table, cells, lines.place());
  if (table.times.empty()) refuse(lines.place(), "there are no rows under the header");
  return table;
}

}  // namespace tandem::text
