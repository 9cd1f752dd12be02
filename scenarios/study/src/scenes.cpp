// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "scenes.hpp"

#include <algorithm>

#include "tandem/stability/fast_period.hpp"
#include "tandem/study/sweep.hpp"
#include "tandem/text/set.hpp"

namespace tandem::study {
namespace {

using scenario::Scenario;
using scenario::Setting;

std::vector<Setting> settings(const std::vector<Given>& all, const FileValues& values) {
  std::vector<Setting> settings;
  for (const Given& one : all) settings.push_back({one.name, one.with(values)});
  return settings;
}

/// Where a sentence names what one of them has set, it begins with the line of the study that does so.
Scenario with(const scenario::ScenarioFile& file, const std::vector<Given>& all, const FileValues& values) {
  const std::vector<Setting> own = settings(all, values);
  try {
    return file.with(own);
  } catch (const Error& error) {
    const std::string sentence = error.what();
    for (const Given& one : all)
      if (sentence.find("--set " + one.name + "=") != std::string::npos)
        refuse(one.place, sentence, error.code());
    throw;
  }
}

/// What is set in a table that has these columns: a key of others keeps the scenario's value.
std::vector<Given> of_columns(const std::vector<Given>& all, const std::vector<std::string>& columns) {
  std::vector<Given> own;
  for (const Given& one : all) {
    const auto needed = one.columns();
    if (std::all_of(needed.begin(), needed.end(), [&](const std::string& name) {
          return std::find(columns.begin(), columns.end(), name) != columns.end();
        }))
      own.push_back(one);
  }
  return own;
}

std::vector<std::string> names_of(const FileValues& values) {
  std::vector<std::string> names;
  for (const auto& [name, value] : values) names.push_back(name);
  return names;
}

/// Alone it is what its metrics judge: no other results are compared or drawn.
Scenario alone(Scenario scenario) {
  scenario.judge.reset(), scenario.reference.reset(), scenario.ladder.reset();
  scenario.plots.clear();
  scenario.animate = false;
  return scenario;
}

/// A column of a reference is a number or a word.
FileValue column_value(const Given& with, const FileValues& per) {
  const text::SetValue value = with.with(per);
  if (const auto* number = std::get_if<double>(&value)) return *number;
  if (const auto* word = std::get_if<std::string>(&value)) return *word;
  refuse(with.place, "column " + with.name + " is true or false; allowed is a number or a word");
}

}  // namespace

const scenario::ScenarioFile& Scenes::file(const Given& name, const FileValues& values) {
  const text::SetValue found = name.with(values);
  const auto* word = std::get_if<std::string>(&found);
  if (!word) refuse(name.place, "scenario stands for a number; allowed is the name of a file");
  const std::lock_guard lock(mutex_);
  auto& one = files_[study_.file.parent_path() / *word];
  if (!one)
    one = located(name.place, [&] {
      return std::make_unique<scenario::ScenarioFile>(study_.file.parent_path() / *word, overrides_);
    });
  return *one;
}

void Scenes::scale_steps(Scenario& scenario, const FileValues& values) {
  if (!study_.steps || of_columns({*study_.steps}, names_of(values)).empty()) return;
  const text::SetValue found = study_.steps->with(values);
  const auto* factor = std::get_if<double>(&found);
  if (!factor || !(*factor > 0.0)) refuse(study_.steps->place, "steps is no number above 0");
  if (*factor == 1.0) return;
  located(study_.steps->place, [&] { scaled_.scale(scenario, *factor); });
}

std::vector<Given> Scenes::set_in(const Table& table) const {
  std::vector<Given> all = table.scenario ? std::vector<Given>() : study_.set;
  all.insert(all.end(), table.set.begin(), table.set.end());
  return all;
}

/// Of a path: "connections", "[0]", "gain", without quotes. A name in brackets may have dots.
std::vector<std::string> parts_of(std::string_view path) {
  std::vector<std::string> parts;
  while (!path.empty()) {
    const std::size_t from = path.front() == '[' ? text::end_of_bracket(path, 0) : 1;
    const std::size_t end = std::min(path.find_first_of(".[", std::min(from, path.size())), path.size());
    std::erase(parts.emplace_back(path.substr(0, end)), '"');
    path.remove_prefix(end < path.size() && path[end] == '.' ? end + 1 : end);
  }
  return parts;
}

bool is_number(const std::string& index) {
  return index.find_first_not_of("[0123456789]") == std::string::npos;
}

/// Whether one is the other or in it. A connection may be called by its number and by its input.
bool overlap(std::string_view a, std::string_view b) {
  const auto of_a = parts_of(a), of_b = parts_of(b);
  return std::equal(of_a.begin(), of_a.begin() + std::min(std::ssize(of_a), std::ssize(of_b)), of_b.begin(),
                    [](const std::string& x, const std::string& y) {
                      const bool may_be = x.starts_with('[') && y.starts_with('[');
                      return x == y || (may_be && is_number(x) != is_number(y));
                    });
}

void refuse_without_effect(const std::vector<std::string>& overrides, const Study& study) {
  const auto check = [&](const std::vector<Given>& set) {
    for (const Given& given : set)
      for (const std::string& one : overrides)
        if (overlap(given.name, std::string_view(one).substr(0, one.find('='))))
          refuse(given.place, "the study sets " + given.name + " itself, so --set " + one +
                                  " would have no effect or not all of it; allowed are keys that it leaves, "
                                  "of connections by the names that it has for them");
  };
  check(study.set);
  for (const Table& table : study.tables) check(table.set);
}

Scenario Scenes::of_row(const Table& table, const FileValues& row) {
  return alone(with(file(name_of(table), row), of_columns(set_in(table), names_of(row)), row));
}

std::vector<Given> Scenes::set_of(const Reference& reference, const Table& table,
                                  const std::vector<std::string>& columns) const {
  std::vector<Given> all = reference.scenario ? std::vector<Given>() : set_in(table);
  all.insert(all.end(), reference.set.begin(), reference.set.end());
  std::vector<std::string> known = columns;
  for (const Given& with : reference.with) known.push_back(with.name);
  return of_columns(all, known);
}

Scenario Scenes::of_reference(const Reference& reference, const Table& table, const FileValues& per,
                              const std::vector<std::string>& columns) {
  FileValues values = per;
  for (const Given& with : reference.with) values[with.name] = column_value(with, per);
  const Given& name = reference.scenario ? *reference.scenario : name_of(table);
  Scenario scenario = with(file(name, values), set_of(reference, table, columns), values);
  scenario = stability::with_fast_period(std::move(scenario), builtins_);
  if (!reference.scenario) scale_steps(scenario, values);
  return alone(std::move(scenario));
}

}  // namespace tandem::study
