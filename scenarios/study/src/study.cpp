// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/study/study.hpp"

#include <algorithm>

#include "has.hpp"
#include "judged.hpp"
#include "tandem/nearest.hpp"

namespace tandem::study {
namespace {

/// Each "${COLUMN}" of a text as `one` has it.
template <class One>
std::string replaced(const std::string& text, const One& one) {
  std::string all;
  std::size_t at = 0;
  for (auto begin = text.find("${"); begin != std::string::npos; begin = text.find("${", at)) {
    const auto end = text.find('}', begin);
    if (end == std::string::npos) break;
    all += text.substr(at, begin - at) + one(text.substr(begin + 2, end - begin - 2));
    at = end + 1;
  }
  return all + text.substr(at);
}

bool has_columns_within(const std::string& text) { return text.find("${") != std::string::npos; }

}  // namespace

std::vector<std::string> Given::columns() const {
  const auto* text = std::get_if<std::string>(&value);
  if (!text) return {};
  std::vector<std::string> within;
  replaced(*text, [&](const std::string& name) { return within.push_back(name), name; });
  if (!text->starts_with("$") || !within.empty()) return within;
  if (!text->starts_with("$(")) return {text->substr(1)};
  if (!text->ends_with(")")) return {};  // with() refuses it
  return located(place, [&] { return text::names_in(text->substr(2, text->size() - 3)); });
}

namespace {

/// "((how is hermite))" in place of a number: true or false.
bool is_condition(const std::string& expression) {
  return expression.starts_with("(") && expression.find(')') == expression.size() - 1 &&
         (expression.find(" is ") != std::string::npos || expression.find(" in [") != std::string::npos);
}

}  // namespace

text::SetValue Given::with(const FileValues& columns) const {
  const auto* text = std::get_if<std::string>(&value);
  if (!text) return value;
  if (has_columns_within(*text))
    return text::SetValue(located(place, [&] {
      return replaced(*text, [&](const std::string& name) {
        const FileValue found = text::referred("$" + name, columns);
        const auto* word = std::get_if<std::string>(&found);
        return word ? *word : text::shown(found);
      });
    }));
  if (!text->starts_with("$")) return value;
  return located(place, [&] {
    const FileValue found = text::referred(*text, columns);
    if (text->starts_with("$(") && is_condition(text->substr(2, text->size() - 3)))
      return text::SetValue(std::get<double>(found) != 0.0);
    return std::visit([](const auto& one) { return text::SetValue(one); }, found);
  });
}

std::vector<std::string> Study::columns() const {
  std::vector<std::string> names;
  for (const Table& table : tables) {
    for (const std::string& column : table.columns)
      if (!has(names, column)) names.push_back(column);
    if (table.search && !has(names, table.search->column)) names.push_back(table.search->column);
  }
  return names;
}

std::vector<std::string> Study::columns_of(const Table& table) const {
  std::vector<std::string> all;
  for (const std::string& name : table.header) {
    const auto names = has(table.metrics, name) ? names_of(metric(name)) : std::vector{name};
    all.insert(all.end(), names.begin(), names.end());
  }
  return all;
}

std::vector<std::string> Study::columns_of_series(const Table& table) const {
  std::vector<std::string> all = table.columns;
  all.insert(all.end(), {"kept", "time"});
  const auto add = [&all](const std::string& name) {
    if (!has(all, name)) all.push_back(name);
  };
  for (const Kept& one : kept) {
    if (one.table != table.name) continue;
    for (const std::string& output : one.outputs) add(output);
    for (const std::string& output : one.outputs)
      if (!one.against.empty()) add(output + "." + one.against);
    for (const std::string& drift : one.metrics) add(drift);
  }
  return all;
}

const Table& Study::table(const std::string& name) const {
  return *std::find_if(tables.begin(), tables.end(), [&](const Table& one) { return one.name == name; });
}

const Reference& Study::reference(const std::string& name) const {
  return *std::find_if(references.begin(), references.end(),
                       [&](const Reference& one) { return one.name == name; });
}

const Metric& Study::metric(const std::string& name) const {
  return *std::find_if(metrics.begin(), metrics.end(), [&](const Metric& one) { return one.name == name; });
}

std::vector<std::string> Study::names_of(const Metric& metric) const {
  std::vector<std::string> names = {metric.name};
  if (metric.window.shift > 0.0) names.push_back(metric.name + ".shift");
  if (!metric.against.empty() && reference(metric.against).floor) names.push_back(metric.name + ".floor");
  if (metric.kind == Metric::Kind::seconds) names.push_back(metric.name + ".processor");
  return names;
}

void Study::keep_tables(const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const Table& table : tables) known.push_back(table.name);
  for (const std::string& name : names)
    if (!has(known, name))
      throw Error(ErrorCode::invalid_argument, file.string() + ": " + unknown("table", name, known));
  std::erase_if(tables, [&](const Table& table) { return !has(names, table.name); });
  std::erase_if(kept, [&](const Kept& one) { return !has(names, one.table); });
  std::erase_if(choices, [&](const Choice& one) { return !has(names, one.by) || !has(names, one.of); });
}

void Study::keep_rows(const std::string& where) {
  const Formula when{where, {file.string()}};
  for (const std::string& name : located(when.place, [&] { return text::names_in(where); }))
    if (const auto known = columns(); !has(known, name))
      throw Error(ErrorCode::invalid_argument, file.string() + ": " + unknown("column", name, known));
  for (Table& table : tables)
    std::erase_if(table.rows,
                  [&](const FileValues& row) { return !is_known(when, row) || value_of(when, row) == 0.0; });
  std::vector<std::string> names;
  for (const Table& table : tables)
    if (!table.rows.empty()) names.push_back(table.name);
  if (names.empty())
    throw Error(ErrorCode::invalid_argument, file.string() + ": no row is left where " + where +
                                                 "; allowed is an expression that holds for one");
  keep_tables(names);
}

bool Study::is_timed(const Table& table) const {
  return std::any_of(table.metrics.begin(), table.metrics.end(),
                     [this](const std::string& name) { return metric(name).is_time(); });
}

}  // namespace tandem::study
