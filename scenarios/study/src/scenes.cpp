// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "scenes.hpp"

#include <algorithm>

#include "tandem/scenario/steps.hpp"
#include "tandem/stability/fast_period.hpp"
#include "tandem/study/sweep.hpp"

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

void Scenes::scale_steps(Scenario& scenario, const FileValues& values) const {
  if (!study_.steps || of_columns({*study_.steps}, names_of(values)).empty()) return;
  const text::SetValue found = study_.steps->with(values);
  const auto* factor = std::get_if<double>(&found);
  if (!factor || !(*factor > 0.0)) refuse(study_.steps->place, "steps is no number above 0");
  if (*factor == 1.0) return;
  located(study_.steps->place, [&] { scenario::scale_steps(scenario, builtins_, *factor); });
}

std::vector<Given> Scenes::set_in(const Table& table) const {
  std::vector<Given> all = table.scenario ? std::vector<Given>() : study_.set;
  all.insert(all.end(), table.set.begin(), table.set.end());
  return all;
}

void refuse_without_effect(const std::vector<std::string>& overrides, const Study& study) {
  const auto check = [&](const std::vector<Given>& set) {
    for (const Given& given : set)
      for (const std::string& one : overrides)
        if (given.name == one.substr(0, one.find('=')))
          refuse(given.place, "the study sets " + given.name + " itself, so --set " + one +
                                  " would have no effect; allowed are keys that it leaves");
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
