// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "tandem/output/json.hpp"

namespace tandem::charts {
namespace {

namespace fs = std::filesystem;

using Texts = std::map<std::string, std::string>;

/// The texts of an object; others are left out.
Texts texts_of(const nlohmann::json& json, const char* key) {
  Texts texts;
  if (const auto it = json.find(key); it != json.end() && it->is_object())
    for (const auto& [name, value] : it->items())
      texts[name] = value.is_string() ? value.get<std::string>() : value.dump();
  return texts;
}

/// "processor: ..   compiler: ..   commit: ..", as far as they are known.
std::string made_of(const nlohmann::json& json) {
  Texts known = texts_of(json, "made");
  std::string line;
  for (const char* key : {"processor", "compiler", "commit"})
    if (known.contains(key)) line += fmt::format("{}{}: {}", line.empty() ? "" : "   ", key, known[key]);
  return line;
}

std::optional<double> as_number(const std::string& cell) {
  double value = 0.0;
  const auto [end, code] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return code == std::errc() && end == cell.data() + cell.size() ? std::optional(value) : std::nullopt;
}

/// "voltage 50 V" for "voltage [V]".
std::string with_value(const std::string& label, const std::string& value) {
  const auto unit = label.rfind(" [");
  if (unit == std::string::npos || !label.ends_with(']')) return label + ' ' + value;
  return label.substr(0, unit + 1) + value + ' ' + label.substr(unit + 2, label.size() - unit - 3);
}

fs::path json_of(const fs::path& folder, const std::string& name) {
  return folder / (name.substr(0, name.find('.')) + ".json");
}

}  // namespace

Table::Table(const fs::path& folder, const std::string& name)
    : csv_(CsvTable::read(folder / (name + ".csv"), {})) {
  const fs::path file = json_of(folder, name);
  if (!fs::exists(file)) return;
  const auto json = output::read_json(file);
  units_ = texts_of(json, "units"), norms_ = texts_of(json, "norms");
  made_ = made_of(json);
}

bool Table::has(const std::string& column) const {
  return std::find(csv_.names().begin(), csv_.names().end(), column) != csv_.names().end();
}

bool Table::is_word(const Quantity& quantity) const {
  if (!has(quantity.text)) return false;
  for (std::size_t row = 0; row < rows(); ++row)
    if (const std::string& cell = csv_[row].text(quantity.text); !cell.empty() && !as_number(cell))
      return true;
  return false;
}

void Table::check(const std::string& column, const text::Place& place) const {
  if (!has(column)) refuse(place, csv_.file().string() + ": column '" + column + "' is missing");
}

std::string Table::label(const Quantity& quantity, const Charts& charts, bool percent) const {
  if (const auto it = charts.names.find(quantity.text); it != charts.names.end())
    return it->second + (percent && it->second.find('%') == std::string::npos ? " [%]" : "");
  const auto it = units_.find(quantity.text);
  const std::string unit = percent ? "%" : it == units_.end() || it->second == "1" ? "" : it->second;
  std::string name = quantity.text;
  if (has(name)) std::replace(name.begin(), name.end(), '_', ' ');
  return unit.empty() ? name : name + " [" + unit + "]";
}

std::vector<std::string> Table::caption(const Chart& chart, const std::vector<Quantity>& shown) const {
  std::vector<std::string> lines = chart.notes;
  for (const Quantity& one : shown)
    if (const auto it = norms_.find(one.text); it != norms_.end()) {
      const std::string line = one.text + ": " + it->second;
      if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(line);
    }
  if (!made_.empty()) lines.push_back(made_);
  return lines;
}

std::optional<double> Table::number(std::size_t row, const Quantity& quantity) const {
  if (has(quantity.text)) {
    const std::string& cell = csv_[row].text(quantity.text);
    const auto value = as_number(cell);
    if (!value && !cell.empty())
      refuse(quantity.place, fmt::format("{}, line {}: {} is a word; allowed is a number",
                                         csv_.file().string(), row + 2, quantity.text));
    return value && std::isfinite(*value) ? value : std::nullopt;
  }
  text::FileValues values;
  for (const std::string& name : text::names_in(quantity.text)) {
    check(name, quantity.place);
    const std::string& cell = csv_[row].text(name);
    if (cell.empty()) return {};
    const auto value = as_number(cell);
    if (value && !std::isfinite(*value)) return {};
    values[name] = value ? text::FileValue(*value) : text::FileValue(cell);
  }
  try {
    return text::evaluated(quantity.text, values);
  } catch (const Error&) {  // its sentence quotes the words, and the file may be none of ours
    refuse(quantity.place,
           fmt::format("{}, line {}: {} can't be evaluated: a column has a word where a number "
                       "is needed, or the expression is wrong",
                       csv_.file().string(), row + 2, quantity.text));
  }
}

bool Table::failed(std::size_t row) const {
  static const std::string status = "status";
  return has(status) && csv_[row].text(status) != "ok";
}

std::vector<std::size_t> Table::chosen(const std::optional<Quantity>& where) const {
  std::vector<std::size_t> all;
  for (std::size_t row = 0; row < rows(); ++row)
    if (!where || number(row, *where).value_or(0.0) != 0.0) all.push_back(row);
  if (all.empty())
    throw Error(ErrorCode::invalid_argument,
                csv_.file().string() + " has no row" + (where ? " where " + where->text : "") + " to draw");
  return all;
}

const std::string& Table::cell(std::size_t row, const std::string& column, const text::Place& place,
                               const Charts& charts) const {
  check(column, place);
  return charts.name_of(csv_[row].text(column));
}

std::string Table::words(std::size_t row, const std::vector<std::string>& columns, const text::Place& place,
                         const Charts& charts) const {
  std::string all;
  for (const std::string& column : columns) {
    check(column, place);
    const std::string& cell = csv_[row].text(column);
    std::string word = charts.name_of(cell);
    if (as_number(cell) && word == cell) word = with_value(label({column, place}, charts, false), cell);
    all += (all.empty() || word.empty() ? "" : ", ") + word;
  }
  return all;
}

}  // namespace tandem::charts
