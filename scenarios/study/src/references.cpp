// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "references.hpp"

#include <algorithm>

#include "expected_time.hpp"
#include "row_key.hpp"
#include "tandem/identification/models.hpp"
#include "tandem/nearest.hpp"
#include "tandem/scenario/about.hpp"
#include "tandem/scenario/assembly.hpp"
#include "tandem/scenario/steps.hpp"

namespace tandem::study {
namespace {

using text::TimeTable;

const std::string& name_in(const Reference& reference, const std::string& output) {
  const auto it = reference.outputs.find(output);
  return it == reference.outputs.end() ? output : it->second;
}

/// One column and its derivatives, by another name.
TimeTable one_of(const TimeTable& table, const std::string& own, const std::string& name) {
  TimeTable one{table.file, table.times, {}, {}};
  for (std::size_t k = 0; k < table.names.size(); ++k)
    if (const bool slope = table.names[k] == "der(" + own + ")"; slope || table.names[k] == own) {
      one.names.push_back(slope ? "der(" + name + ")" : name);
      one.columns.push_back(table.columns[k]);
    }
  return one;
}

std::vector<std::string> columns_of(const FileValues& row) {
  std::vector<std::string> columns;
  for (const auto& [column, value] : row) columns.push_back(column);
  return columns;
}

/// Before its metrics are known.
bool may_be_kept(const Kept& kept, const FileValues& row) {
  return !kept.where || !is_known(*kept.where, row) || value_of(*kept.where, row) != 0.0;
}

}  // namespace

std::string ReferenceRun::text() const {
  const std::string values = row_text(reference->per, per);
  return "reference " + reference->name + (values.empty() ? "" : " (" + values + ")");
}

/// Rows with other columns leave other keys of the scenario alone, and tables may have keys of their own.
std::string References::key(const Reference& reference, const Table& table, const FileValues& row) const {
  std::string key = reference.name + '\n' + row_key(reference.per, row);
  if (!reference.scenario && (table.scenario || !table.set.empty())) key += '\n' + table.name + '\n';
  for (const Given& one : scenes_.set_of(reference, table, columns_of(row))) key += '\n' + one.name;
  return key;
}

void References::add_kept(const Kept& kept, const std::string& reference,
                          std::vector<std::string>& to) const {
  if (kept.against == reference) to.insert(to.end(), kept.outputs.begin(), kept.outputs.end());
  for (const std::string& name : kept.metrics)
    for (auto& output : referred_outputs({&study_.metric(name)}, reference)) to.push_back(std::move(output));
}

void References::need(const std::vector<const Metric*>& metrics, const Table& table,
                      const FileValues& of_table) {
  FileValues row = of_table;
  if (table.search) row[table.search->column] = table.search->from;  // its own value is not known before
  for (const Reference& reference : study_.references) {
    auto outputs = referred_outputs(metrics, reference.name);
    for (const Kept& kept : study_.kept)
      if (kept.table == table.name && may_be_kept(kept, row)) add_kept(kept, reference.name, outputs);
    if (outputs.empty()) continue;
    FileValues per;
    if (table.search &&
        std::find(reference.per.begin(), reference.per.end(), table.search->column) != reference.per.end())
      refuse(reference.place, "references." + reference.name + ".per has " + table.search->column +
                                  ", which is searched for; allowed are other columns");
    for (const std::string& column : reference.per)
      if (const auto it = row.find(column); it != row.end()) per[column] = it->second;
    ReferenceRun*& run = by_key_[key(reference, table, row)];
    if (!run)
      run = runs_
                .emplace_back(
                    std::make_unique<ReferenceRun>(ReferenceRun{&reference, &table, per, columns_of(row)}))
                .get();
    for (const std::string& output : outputs)
      if (std::find(run->outputs.begin(), run->outputs.end(), output) == run->outputs.end())
        run->outputs.push_back(output);
  }
}

const ReferenceRun& References::of(const std::string& reference, const Table& table,
                                   const FileValues& row) const {
  return *by_key_.at(key(study_.reference(reference), table, row));
}

TableOf References::tables(const Metric& metric, const scenario::Traces& traces, const Table& table,
                           const FileValues& row) const {
  return [&](const std::string& name) -> const TimeTable& {
    const auto it = std::find_if(metric.referred.begin(), metric.referred.end(),
                                 [&](const Metric::Referred& one) { return one.name == name; });
    if (it == metric.referred.end()) return traces.of(name);
    const ReferenceRun& reference = of(it->reference, table, row);
    if (!reference.failure.empty()) throw Error(ErrorCode::numerical, reference.failure);
    return reference.tables.at(it->output);
  };
}

void References::make(std::size_t which, const std::function<bool()>& going) {
  ReferenceRun& run = *runs_[which];
  run.reference->file.empty() ? simulate(run, going) : read(run);
}

double References::expected_seconds(std::size_t which) {
  constexpr double patience = 0.5;  // [s]
  const ReferenceRun& run = *runs_[which];
  if (!run.reference->file.empty()) return 0.0;
  const auto scenario = scenes_.of_reference(*run.reference, *run.table, run.per, run.columns);
  scenario::Assembly assembly(scenario, builtins_);
  assembly.initialize();
  const double once = study::expected_seconds(assembly, scenario.start, scenario.stop, patience);
  return run.reference->floor ? 3.0 * once : once;
}

void References::read(ReferenceRun& run) const {
  try {
    const TimeTable table = scenario::read_finished(run.reference->file);
    for (const std::string& output : run.outputs) {
      const std::string& own = name_in(*run.reference, output);
      if (std::find(table.names.begin(), table.names.end(), own) == table.names.end())
        throw Error(ErrorCode::invalid_argument,
                    table.file.string() + ": " + unknown("column", own, table.names));
      run.tables[output] = one_of(table, own, output);
    }
  } catch (const Error& error) {
    refuse(run.reference->place, run.text() + ": " + error.what());
  }
}

void References::simulate(ReferenceRun& run, const std::function<bool()>& going) {
  scenario::Scenario scenario = scenes_.of_reference(*run.reference, *run.table, run.per, run.columns);
  scenario::Scenario finer = scenario;
  if (run.reference->floor)
    located(run.reference->place, [&] { scenario::scale_steps(finer, builtins_, 0.5); });
  try {
    run.tables = tables_of(run, scenario, going);
    if (run.reference->floor) run.finer = tables_of(run, finer, going);
  } catch (const Error& error) {
    if (error.code() == ErrorCode::invalid_argument)
      refuse(run.reference->place, run.text() + ": " + error.what(), error.code());
    run.failure = run.text() + ": " + error.what();
  }
}

OutputTables References::tables_of(ReferenceRun& run, const scenario::Scenario& scenario,
                                   const std::function<bool()>& going) const {
  identification::Models models(identification::Models::Without::refused);
  const Builtins builtins = run.reference->models ? models.replacing(builtins_) : builtins_;
  scenario::Assembly assembly(scenario, builtins);
  std::vector<std::string> names;
  for (const std::string& output : run.outputs) names.push_back(name_in(*run.reference, output));
  scenario::Traces traces(assembly.topology(), names, run.text());
  assembly.coordinator().observe(&traces);
  assembly.initialize();
  while (assembly.coordinator().round())
    if (!going()) throw Error(ErrorCode::numerical, "interrupted");
  OutputTables tables;
  for (const std::string& output : run.outputs) {
    const std::string& own = name_in(*run.reference, output);
    tables[output] = one_of(traces.of(own), own, output);
    run.units[output] = traces.unit(own);
  }
  return tables;
}

}  // namespace tandem::study
