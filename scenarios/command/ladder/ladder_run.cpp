// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "ladder/ladder_run.hpp"

#include <algorithm>

#include "tandem/coordinator/units.hpp"
#include "tandem/output/processor_time.hpp"
#include "tandem/scenario/about.hpp"
#include "tandem/scenario/assembly.hpp"
#include "tandem/scenario/run.hpp"
#include "tandem/stability/fast_period.hpp"

namespace tandem::scenario {
namespace {

const LadderEntry& ladder_of(const Scenario& scene) {
  if (scene.ladder) return *scene.ladder;
  refuse({scene.file.string()}, "there is no table [ladder] with [[ladder.rungs]] in it");
}

void go_on(const std::function<bool()>& going) {
  if (!going()) throw Error(ErrorCode::numerical, "interrupted");
}

/// Its scalar outputs and their units, by name.
std::map<std::string, std::string> outputs_of(const Topology& topology) {
  std::map<std::string, std::string> units;
  for (int i = 0; i < topology.size(); ++i) {
    const auto names = topology.output_names(i);
    std::size_t k = 0;
    for (const Port& port : topology.info(i).outputs)
      for (int element = 0; element < port.size; ++element) units[names[k++]] = port.unit;
  }
  return units;
}

const std::string& name_in(const LadderRung& rung, const std::string& quantity) {
  const auto it = rung.outputs.find(quantity);
  return it == rung.outputs.end() ? quantity : it->second;
}

void add_constants(text::TimeTable& table, const LadderRung& rung) {
  for (const auto& [quantity, value] : rung.constants) {
    table.names.push_back(quantity);
    table.columns.emplace_back(table.times.size(), value);
  }
}

bool is_results(const std::filesystem::path& file) { return file.extension() == ".csv"; }

/// Runs alone what it is judged by: no other results are compared or drawn.
Scenario read_rung(const LadderRung& entry, const std::vector<std::string>& overrides) {
  std::vector<std::string> all = entry.overrides;
  all.insert(all.end(), overrides.begin(), overrides.end());
  Scenario rung = located(entry.place, [&] { return read(entry.file, all); });
  if (rung.recording.own)
    refuse(entry.place, "rung '" + entry.name + "' records at own steps; record.clock has to be a subsystem");
  rung.judge.reset(), rung.reference.reset(), rung.ladder.reset();
  rung.plots.clear();
  return rung;
}

text::TimeTable read_results(const LadderRung& entry) {
  return located(entry.place, [&] {
    if (const std::string what = unfinished(entry.file); !what.empty())
      throw Error(ErrorCode::invalid_argument,
                  "rung '" + entry.name + "': " + what + "; allowed is one that is 'ok'");
    return text::TimeTable::read(entry.file);
  });
}

/// With the names of the judged quantities.
text::TimeTable renamed(text::TimeTable table, const LadderRung& entry,
                        const std::vector<std::string>& quantities) {
  for (std::string& column : table.names)
    for (const std::string& quantity : quantities) {
      const std::string& own = name_in(entry, quantity);
      if (column == own) column = quantity;
      if (column == "der(" + own + ")") column = "der(" + quantity + ")";
    }
  add_constants(table, entry);
  return table;
}

}  // namespace

Ladder::Ladder(const Scenario& scene, const std::vector<std::string>& overrides, const Builtins& builtins)
    : entry_(ladder_of(scene)), builtins_(builtins) {
  for (const LadderRung& entry : entry_.rungs) {
    Rung& rung = rungs_.emplace_back(Rung{entry, {}, {}, {}});
    if (is_results(entry.file))
      rung.results = read_results(entry);
    else
      rung.scenario = stability::with_fast_period(read_rung(entry, overrides), builtins_);
    take_quantities(rung);
  }
  check_richest();
}

/// Records those that the rung has.
void Ladder::take_quantities(Rung& rung) {
  std::map<std::string, std::string> known;
  if (rung.scenario)
    known = outputs_of(Assembly(*rung.scenario, builtins_).topology());
  else
    for (const std::string& name : rung.results->names) known[name];
  for (const LadderQuantity& q : entry_.quantities) {
    if (rung.entry.constants.contains(q.quantity)) continue;
    const std::string& own = name_in(rung.entry, q.quantity);
    if (known.contains(own)) {
      rung.quantities.push_back(q.quantity);
      if (rung.scenario) units_[q.quantity] = known[own];
    } else if (rung.entry.outputs.contains(q.quantity)) {
      refuse(rung.entry.place, "rung '" + rung.entry.name + "' has no output " + own);
    }
  }
  if (rung.quantities.empty())
    refuse(rung.entry.place, "rung '" + rung.entry.name + "' gives none of the judged quantities");
  if (!rung.scenario) return;
  rung.scenario->recording.ports.clear();
  rung.scenario->recording.rows = {};
  for (const std::string& q : rung.quantities)
    rung.scenario->recording.ports.push_back(name_in(rung.entry, q));
}

void Ladder::check_richest() const {
  const Rung& richest = rungs_.back();
  for (const LadderQuantity& q : entry_.quantities) {
    const auto& has = richest.quantities;
    if (std::find(has.begin(), has.end(), q.quantity) == has.end() &&
        !richest.entry.constants.contains(q.quantity))
      refuse(q.place, "the richest rung '" + richest.entry.name + "' gives no " + q.quantity);
    factor(q);
  }
}

/// From the unit of its output, which is that of the richest rung that is a scenario, to that of the judge.
double Ladder::factor(const LadderQuantity& judged) const {
  const auto it = units_.find(judged.quantity);
  const std::string unit = it == units_.end() ? judged.unit : it->second;
  const auto conversion = convert_unit(unit, judged.unit.empty() ? unit : judged.unit);
  if (!conversion)
    refuse(judged.place, "unit '" + judged.unit + "' of " + judged.quantity + ", which is in '" + unit +
                             "'; allowed is a unit of the same quantity");
  return conversion->factor;
}

RungRun Ladder::run(std::size_t index, const std::filesystem::path& folder,
                    const std::function<bool()>& going) {
  const Rung& rung = rungs_[index];
  RungRun result{rung.entry.name, {}, "", 0.0};
  if (!rung.scenario) {
    result.table = renamed(*rung.results, rung.entry, rung.quantities);
    return result;
  }
  const auto own = folder / rung.entry.name;
  const RunEnd end =
      scenario::run(*rung.scenario, builtins_, {.folder = own, .compares = false}, {.going = going});
  if (end.status == "interrupted") throw Error(ErrorCode::numerical, end.status);
  if (end.status == "ok")
    result.table = renamed(text::TimeTable::read(own), rung.entry, rung.quantities);
  else
    result.failure = end.message;
  return result;
}

double Ladder::seconds(std::size_t index, const std::function<bool()>& going) const {
  if (!rungs_[index].scenario) return 0.0;
  Assembly assembly(*rungs_[index].scenario, builtins_);
  assembly.initialize();
  const double began = output::processor_time();
  while (assembly.coordinator().round()) go_on(going);
  return output::processor_time() - began;
}

std::vector<LadderColumn> Ladder::columns(const std::vector<RungRun>& runs) const {
  std::vector<LadderColumn> all;
  for (const LadderQuantity& judged : entry_.quantities)
    all.push_back(ladder_column(runs, judged, factor(judged)));
  return all;
}

}  // namespace tandem::scenario
