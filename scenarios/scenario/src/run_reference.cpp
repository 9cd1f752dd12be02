// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "run_reference.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tandem/scenario/about.hpp"
#include "tandem/scenario/run.hpp"

namespace tandem::scenario {
namespace {

text::TimeTable read(const Scenario& of) {
  if (of.recording.own)
    refuse(of.place("record.clock"),
           "record.clock is 'own', which writes no results.csv to compare with the reference; name a "
           "subsystem, or say --no-reference");
  return reference_of(of);
}

/// The run would write over what it is compared with.
void check_elsewhere(const Scenario& of, const text::TimeTable& table, const Recorder& recorder) {
  const auto whole = [](const std::filesystem::path& file) {
    return std::filesystem::weakly_canonical(file);
  };
  for (const auto& file : recorder.files())
    if (whole(file) == whole(table.file))
      refuse(of.reference->place, "the reference is " + table.file.string() +
                                      ", which this run writes; allowed is another folder for one of them");
}

/// Without a time that all have there would be nothing to compare at the end.
void check_window(const Scenario& of, const text::TimeTable& table, const Place& place,
                  const Measure& measure) {
  const RowRules& rows = of.recording.rows;
  const double first = std::max(measure.from, table.times.front()),
               last = std::min(measure.to, table.times.back()),
               begin = std::max({first, of.start - measure.shift, rows.from - measure.shift}),
               end = std::min({last, of.stop + measure.shift, rows.to + measure.shift});
  if (begin > end)
    refuse(place,
           fmt::format("no time is left to compare at: recorded is {} s to {} s, counted {} s to {} s, "
                       "and the reference has {} s to {} s",
                       std::max(of.start, rows.from), std::min(of.stop, rows.to), measure.from, measure.to,
                       table.times.front(), table.times.back()));
}

}  // namespace

text::TimeTable reference_of(const Scenario& scenario) {
  return located(scenario.reference->place, [&] { return read_finished(scenario.reference->file); });
}

RunReference::RunReference(const Scenario& scenario, const Recorder& recorder)
    : scenario_(scenario), table_(read(scenario)) {
  check_elsewhere(scenario, table_, recorder);
  check_window(scenario, table_, scenario.reference->place, scenario.reference->measure);
  if (!scenario.judge) return;
  check_judged(recorder);
  check_window(scenario, table_, scenario.judge->place, scenario.judge->measure);
}

void RunReference::check_judged(const Recorder& recorder) const {
  const std::string& quantity = scenario_.judge->quantity;
  const auto& columns = recorder.columns();
  if (std::none_of(columns.begin(), columns.end(), [&](const auto& c) { return c.name == quantity; }))
    refuse(scenario_.judge->place,
           "judge.quantity " + quantity + " is not recorded; name it in record.ports, or say --no-reference");
  if (std::find(table_.names.begin(), table_.names.end(), quantity) == table_.names.end())
    refuse(scenario_.judge->place, "judge.quantity " + quantity + " is no column of the reference " +
                                       scenario_.reference->file.string());
}

void RunReference::compare(const std::filesystem::path& folder) {
  try {
    const auto own = text::TimeTable::read(folder);
    const auto all = scenario::compare(own, table_, {}, scenario_.reference->measure);
    report_ = scenario::text(all);
    for (const auto& d : all.columns)
      judge(d, scenario_.reference->tolerance, scenario_.reference->measure.norm);
    if (const auto& by = scenario_.judge) {
      const auto judged = scenario::compare(own, table_, {by->quantity}, by->measure);
      if (by->measure != scenario_.reference->measure) report_ += "judged by\n" + scenario::text(judged);
      judge(judged.columns[0], by->tolerance, by->measure.norm);
    }
  } catch (const Error& error) {
    outside_.push_back(error.what());
  }
}

void RunReference::judge(const Difference& d, double tolerance, Norm norm) {
  const std::string sentence = scenario::text(d, tolerance, norm);
  const bool is_told = std::find(outside_.begin(), outside_.end(), sentence) != outside_.end();
  const bool is_outside = !(d.size(norm) <= tolerance);
  if (is_outside && !is_told) outside_.push_back(sentence);
  if (!is_outside && differences_.contains(d.column)) return;
  differences_[d.column] = {
      {"relative", d.relative}, {"absolute", d.absolute},         {"time", d.time},
      {"rms", d.rms},           {"relative_rms", d.relative_rms}, {"norm", norm == Norm::rms ? "rms" : "max"},
      {"tolerance", tolerance}};
}

nlohmann::ordered_json RunReference::figures() const {
  return {{"file", scenario_.reference->file.string()},
          {"within", outside_.empty()},
          {"differences", differences_}};
}

std::string RunReference::report() const {
  if (report_.empty()) return "";
  return fmt::format("compared with {}\n{}", scenario_.reference->file.string(), report_);
}

}  // namespace tandem::scenario
