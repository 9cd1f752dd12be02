// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "ladder/ladder_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

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

/// What is wrong with a rung is told with its name and place.
template <class Work>
auto named(const LadderRung& entry, const Work& work) -> decltype(work()) {
  try {
    return work();
  } catch (const Error& error) {
    refuse(entry.place, "rung '" + entry.name + "': " + error.what(), error.code());
  }
}

bool is_results(const std::filesystem::path& file) {
  return file.extension() == ".csv" || file.extension() == ".npy" || std::filesystem::is_directory(file);
}

std::vector<std::string> names_of(const std::vector<LadderQuantity>& quantities) {
  std::vector<std::string> all;
  for (const LadderQuantity& one : quantities) all.push_back(one.quantity);
  return all;
}

/// Runs alone what it is judged by: no other results are compared or drawn.
Scenario read_rung(const LadderRung& entry, const std::vector<std::string>& overrides) {
  std::vector<std::string> all = entry.overrides;
  all.insert(all.end(), overrides.begin(), overrides.end());
  Scenario rung = named(entry, [&] { return read(entry.file, all); });
  if (rung.recording.own)
    refuse(entry.place, "rung '" + entry.name + "' records at own steps; record.clock has to be a subsystem");
  rung.judge.reset(), rung.reference.reset(), rung.ladder.reset();
  rung.plots.clear();
  return rung;
}

text::TimeTable read_results(const LadderRung& entry) {
  return named(entry, [&] { return read_finished(entry.file); });
}

/// Takes the units off the headings of a file, "NAME [UNIT]", and gives them by name; empty where there is none.
std::map<std::string, std::string> take_units(text::TimeTable& table) {
  std::map<std::string, std::string> units;
  for (std::string& name : table.names) {
    name.resize(name.find_last_not_of(' ') + 1);
    const auto at = name.find(" [");
    const bool has_unit = at != std::string::npos && name.ends_with(']');
    const std::string unit = has_unit ? name.substr(at + 2, name.size() - at - 3) : "";
    if (has_unit) name.resize(at);
    units[name] = unit;
  }
  return units;
}

/// Adds a column of `from`, if it is there, by another name and in other units.
void add_column(const text::TimeTable& from, const std::string& name, const std::string& as,
                const UnitConversion& in, text::TimeTable& to) {
  const auto at = std::ranges::find(from.names, name) - from.names.begin();
  if (at == std::ssize(from.names)) return;
  to.names.push_back(as);
  to.columns.push_back(from.columns[static_cast<std::size_t>(at)]);
  for (double& value : to.columns.back()) value = in.factor * value + in.shift;
}

}  // namespace

std::vector<std::string> overrides_of_rungs(std::vector<std::string> all) {
  std::erase_if(all, [](const std::string& one) { return one.starts_with("ladder."); });
  return all;
}

bool names_code_in_rungs(const Scenario& scene, const std::vector<std::string>& overrides,
                         const Builtins& builtins) {
  return std::ranges::any_of(ladder_of(scene).rungs, [&](const LadderRung& rung) {
    return !is_results(rung.file) && names_code(read_rung(rung, overrides), builtins);
  });
}

Ladder::Ladder(const Scenario& scene, const std::vector<std::string>& overrides, const Builtins& builtins)
    : entry_(ladder_of(scene)), builtins_(builtins) {
  for (const LadderRung& entry : entry_.rungs) {
    Rung& rung = rungs_.emplace_back(Rung{entry, {}, {}, {}, {}});
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
    known = named(rung.entry, [&] { return outputs_of(Assembly(*rung.scenario, builtins_).topology()); });
  else
    known = take_units(*rung.results);
  for (const LadderQuantity& q : entry_.quantities) {
    if (rung.entry.constants.contains(q.quantity)) continue;
    const std::string& own = name_in(rung.entry, q.quantity);
    if (known.contains(own)) {
      rung.quantities.push_back(q.quantity);
      rung.units[q.quantity] = known[own];
      if (rung.scenario || !units_.contains(q.quantity)) units_[q.quantity] = known[own];
    } else if (rung.entry.outputs.contains(q.quantity)) {
      refuse(rung.entry.place, "rung '" + rung.entry.name + "' has no output " + own);
    }
  }
  if (rung.quantities.empty())
    refuse(rung.entry.place, fmt::format("rung '{}' gives none of the judged quantities: {}", rung.entry.name,
                                         fmt::join(names_of(entry_.quantities), ", ")));
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
    for (const Rung& rung : rungs_) conversion_of(rung, q.quantity);
  }
}

/// From the unit of its output, which is that of the richest rung that is a scenario, to that of the judge.
double Ladder::factor(const LadderQuantity& judged) const {
  const auto it = units_.find(judged.quantity);
  const std::string unit = it == units_.end() || it->second.empty() ? judged.unit : it->second;
  const auto conversion = convert_unit(unit, judged.unit.empty() ? unit : judged.unit);
  if (!conversion)
    refuse(judged.place, "unit '" + judged.unit + "' of " + judged.quantity + ", which is in '" + unit +
                             "'; allowed is a unit of the same quantity");
  return conversion->factor;
}

/// From the unit of a rung's output to that of the richest rung that is a scenario.
UnitConversion Ladder::conversion_of(const Rung& rung, const std::string& quantity) const {
  const auto it = rung.units.find(quantity);
  if (it == rung.units.end() || it->second.empty()) return {1.0, 0.0};
  const auto conversion = convert_unit(it->second, units_.at(quantity));
  if (!conversion)
    refuse(rung.entry.place, "rung '" + rung.entry.name + "' gives " + quantity + " in '" + it->second +
                                 "', a richer one in '" + units_.at(quantity) +
                                 "'; allowed is a unit of the same quantity");
  return *conversion;
}

/// The judged quantities by their names, with derivatives where there are.
text::TimeTable Ladder::judged_of(const Rung& rung, const text::TimeTable& all) const {
  text::TimeTable judged{all.file, all.times, {}, {}};
  for (const std::string& quantity : rung.quantities) {
    const UnitConversion to = conversion_of(rung, quantity);
    const std::string& own = name_in(rung.entry, quantity);
    add_column(all, own, quantity, to, judged);
    add_column(all, "der(" + own + ")", "der(" + quantity + ")", {to.factor, 0.0}, judged);
  }
  add_constants(judged, rung.entry);
  return judged;
}

void Ladder::check_folder(const std::filesystem::path& folder) const {
  const auto whole = std::filesystem::weakly_canonical(folder);
  for (const Rung& rung : rungs_) {
    if (!rung.results) continue;
    const auto from = std::filesystem::weakly_canonical(rung.results->file).lexically_relative(whole);
    if (!from.empty() && *from.begin() != "..")
      refuse(rung.entry.place, "rung '" + rung.entry.name + "' is read from " + rung.results->file.string() +
                                   ", where the ladder writes; allowed is a file outside of " +
                                   folder.string());
  }
}

RungRun Ladder::run(std::size_t index, const std::filesystem::path& folder,
                    const std::function<bool()>& going) {
  const Rung& rung = rungs_[index];
  RungRun result{rung.entry.name, {}, "", 0.0};
  if (!rung.scenario) {
    result.table = judged_of(rung, *rung.results);
    return result;
  }
  const auto own = folder / rung.entry.name;
  const RunEnd end =
      scenario::run(*rung.scenario, builtins_, {.folder = own, .compares = false}, {.going = going});
  if (end.status == "interrupted") throw Error(ErrorCode::numerical, end.status);
  if (end.status == "ok")
    result.table = judged_of(rung, text::TimeTable::read(own));
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
