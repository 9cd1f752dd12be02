// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "scenario/ladder_run.hpp"

#include <time.h>

#include <algorithm>

#include "output/lock.hpp"
#include "scenario/assembly.hpp"
#include "tandem/coordinator/units.hpp"

namespace tandem::scenario {
namespace {

const LadderEntry& ladder_of(const Scenario& scene) {
  if (scene.ladder) return *scene.ladder;
  refuse({scene.file.string()}, "there is no table [ladder] with [[ladder.rungs]] in it");
}

/// Of this process, all its threads [s].
double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
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

}  // namespace

Ladder::Ladder(const Scenario& scene, const std::vector<std::string>& overrides, const Builtins& builtins)
    : entry_(ladder_of(scene)), builtins_(builtins) {
  for (const LadderRung& rung : entry_.rungs) rungs_.push_back(read_rung(rung, overrides));
}

/// Records those that the rung has; their names as the judge calls them.
std::vector<std::string> Ladder::take_quantities(Scenario& rung, const LadderRung& entry) const {
  const auto known = outputs_of(Assembly(rung, builtins_).topology());
  std::vector<std::string> names;
  rung.recording.ports.clear();
  rung.recording.rows = {};
  for (const LadderQuantity& q : entry_.quantities)
    if (entry.constants.contains(q.quantity)) {
      continue;
    } else if (known.contains(name_in(entry, q.quantity))) {
      names.push_back(q.quantity);
      rung.recording.ports.push_back(name_in(entry, q.quantity));
    } else if (entry.outputs.contains(q.quantity)) {
      refuse(entry.place, "rung '" + entry.name + "' has no output " + name_in(entry, q.quantity));
    }
  if (names.empty()) refuse(entry.place, "rung '" + entry.name + "' gives none of the judged quantities");
  return names;
}

RungRun Ladder::run(std::size_t index, const std::filesystem::path& folder,
                    const std::function<bool()>& going) {
  const LadderRung& entry = entry_.rungs[index];
  RungRun result{entry.name, {}, "", 0.0};
  const auto names = take_quantities(rungs_[index], entry);
  try {
    const output::FolderLock kept(folder / entry.name, [](const std::string&) {});
    Assembly assembly(rungs_[index], builtins_);
    const auto recorder = assembly.recorder(folder / entry.name);
    assembly.coordinator().observe(recorder.get());
    assembly.initialize();
    while (assembly.coordinator().round()) recorder->between_rounds(), go_on(going);
    recorder->close();
    result.table = text::TimeTable::read(folder / entry.name);
    for (std::string& column : result.table->names)
      for (const std::string& quantity : names)
        if (column == name_in(entry, quantity)) column = quantity;
    add_constants(*result.table, entry);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::numerical || !going()) throw;
    result.failure = error.what();
  }
  return result;
}

double Ladder::seconds(std::size_t rung, const std::function<bool()>& going) const {
  Assembly assembly(rungs_[rung], builtins_);
  assembly.initialize();
  const double began = processor_time();
  while (assembly.coordinator().round()) go_on(going);
  return processor_time() - began;
}

std::string Ladder::unit_in_richest(const LadderQuantity& judged) const {
  const auto units = outputs_of(Assembly(rungs_.back(), builtins_).topology());
  const auto it = units.find(name_in(entry_.rungs.back(), judged.quantity));
  if (it == units.end())
    refuse(judged.place, "the richest rung '" + entry_.rungs.back().name + "' gives no " + judged.quantity);
  return it->second;
}

std::vector<LadderColumn> Ladder::columns(const std::vector<RungRun>& runs) const {
  std::vector<LadderColumn> all;
  for (const LadderQuantity& judged : entry_.quantities) {
    const std::string unit = unit_in_richest(judged);
    const auto conversion = convert_unit(unit, judged.unit.empty() ? unit : judged.unit);
    if (!conversion)
      refuse(judged.place, "unit '" + judged.unit + "' of " + judged.quantity + ", which is in '" + unit +
                               "'; allowed is a unit of the same quantity");
    all.push_back(ladder_column(runs, judged, conversion->factor));
  }
  return all;
}

}  // namespace tandem::scenario
