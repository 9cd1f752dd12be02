// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/text/time_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include "tandem/bytes.hpp"
#include "tandem/input_file.hpp"
#include "tandem/npy.hpp"
#include "tandem/text/place.hpp"

namespace tandem::text {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_columns = std::size_t{1} << 20;
constexpr std::size_t longest_npy_head = std::size_t{1} << 26;  // bytes

/// One line at a time into cells; a cell may be quoted, with "" for a quote in it.
class Lines {
 public:
  explicit Lines(const fs::path& file) : place_{file.string()}, in_(file) {}

  bool next(std::vector<std::string>& cells) {
    if (!in_.line(line_)) return false;
    if (++place_.line == 1 && line_.starts_with("\xEF\xBB\xBF")) line_.erase(0, 3);  // UTF-8's mark
    if (line_.ends_with('\r')) line_.pop_back();
    cells.assign(1, {});
    bool quoted = false;
    char before = ',';
    for (const char c : line_) {
      if (c == '"') quoted = !quoted;
      const bool second_of_pair = c == '"' && before == '"' && quoted;
      if (c == ',' && !quoted)
        add_cell(cells);
      else if (c != '"' || second_of_pair)
        cells.back() += c;
      before = c;
    }
    if (quoted) refuse(place_, "a quotation mark is not closed; allowed are pairs of them");
    return true;
  }
  const Place& place() const { return place_; }

 private:
  void add_cell(std::vector<std::string>& cells) const {
    if (cells.size() == most_columns)
      refuse(place_, "there are more than " + std::to_string(most_columns) + " columns, the most allowed");
    cells.emplace_back();
  }

  Place place_;
  InputFile in_;
  std::string line_;
};

/// column: from 0. What stands there is not told: the file may be none of ours.
double number(const std::string& cell, std::size_t column, const Place& place) {
  double value = 0.0;
  const auto [end, code] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (code != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value))
    refuse(place, "column " + std::to_string(column + 1) +
                      (cell.empty() ? " is empty" : " holds something else") +
                      "; allowed is a finite number");
  return value;
}

void read_header(TimeTable& table, const std::vector<std::string>& cells, const Place& place) {
  if (cells[0] != "time") refuse(place, "the first column has another name; allowed is time");
  table.names.assign(cells.begin() + 1, cells.end());
  table.columns.resize(table.names.size());
  std::vector<std::string> sorted = table.names;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice == sorted.end()) return;
  const auto second = std::find(std::find(cells.begin() + 1, cells.end(), *twice) + 1, cells.end(), *twice);
  refuse(place, "the name of column " + std::to_string(second - cells.begin() + 1) + " is there twice");
}

void read_row(TimeTable& table, const std::vector<std::string>& cells, const Place& place) {
  if (cells.size() != table.names.size() + 1)
    refuse(place, "the row has " + std::to_string(cells.size()) + " cells; the header has " +
                      std::to_string(table.names.size() + 1));
  const double time = number(cells[0], 0, place);
  if (!table.times.empty() && time < table.times.back()) refuse(place, "time falls; it must rise or stay");
  table.times.push_back(time);
  for (std::size_t k = 0; k < table.names.size(); ++k)
    table.columns[k].push_back(cells[k + 1].empty() ? std::numeric_limits<double>::quiet_NaN()
                                                    : number(cells[k + 1], k + 1, place));
}

void read_csv(TimeTable& table) {
  Lines lines(table.file);
  std::vector<std::string> cells;
  if (!lines.next(cells)) refuse(lines.place(), "the file is empty; a header row is missing");
  read_header(table, cells, lines.place());
  while (lines.next(cells)) read_row(table, cells, lines.place());
}

/// The numbers of a row; only an empty cell is no finite one.
void read_row(TimeTable& table, const std::vector<double>& cells, const Place& place) {
  const std::string row = "row " + std::to_string(table.times.size() + 1);
  if (!std::isfinite(cells[0])) refuse(place, row + " has no finite time");
  if (!table.times.empty() && cells[0] < table.times.back())
    refuse(place, "time falls in " + row + "; it must rise or stay");
  table.times.push_back(cells[0]);
  for (std::size_t k = 1; k < cells.size(); ++k) {
    if (std::isinf(cells[k]))
      refuse(place,
             "column " + std::to_string(k + 1) + " is infinite in " + row + "; allowed is a finite number");
    table.columns[k - 1].push_back(cells[k]);
  }
}

void read_npy(TimeTable& table) {
  const Place place{table.file.string()};
  InputFile in(table.file);
  std::string first(std::min<std::uint64_t>(in.size(), longest_npy_head), '\0');
  first.resize(in.read(std::as_writable_bytes(std::span(first))));
  const NpyHead head = located(place, [&] { return read_npy_head(std::as_bytes(std::span(first))); });
  if (head.names.empty() || head.rows > (in.size() - head.size) / (8 * head.names.size()))
    refuse(place, "it has fewer rows than its head says");
  read_header(table, head.names, place);
  in.seek(head.size);
  std::vector<double> cells(head.names.size());
  std::vector<std::byte> bytes(8 * cells.size());
  for (std::uint64_t row = 0; row < head.rows; ++row) {
    in.read(bytes);
    for (std::size_t k = 0; k < cells.size(); ++k)
      cells[k] = from_wire<double>(std::span(bytes).subspan(8 * k));
    read_row(table, cells, place);
  }
}

/// Of a folder the file that is there.
fs::path file_at(const fs::path& place) {
  if (!fs::is_directory(place)) return place;
  for (const char* name : {"results.npy", "results.csv"})
    if (fs::exists(place / name)) return place / name;
  refuse(Place{place.string()}, "it is a folder without results.csv and results.npy");
}

}  // namespace

TimeTable TimeTable::read(const fs::path& place) {
  TimeTable table;
  table.file = file_at(place);
  table.file.extension() == ".npy" ? read_npy(table) : read_csv(table);
  if (table.times.empty()) refuse(Place{table.file.string()}, "there are no rows");
  return table;
}

}  // namespace tandem::text
