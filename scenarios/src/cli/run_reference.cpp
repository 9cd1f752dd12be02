// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "cli/run_reference.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/commands.hpp"
#include "view/about.hpp"

namespace tandem::cli {
namespace {

text::TimeTable read(const scenario::Scenario& of) {
  if (of.recording.own)
    scenario::refuse(
        of.place("record.clock"),
        "record.clock is 'own', which writes no results.csv to compare with the reference; name a "
        "subsystem, or say --no-reference");
  return scenario::located(of.reference->place, [&] {
    if (const std::string what = view::unfinished(of.reference->file); !what.empty())
      throw Error(ErrorCode::invalid_argument, "reference " + what + "; allowed is one that is 'ok'");
    return text::TimeTable::read(of.reference->file);
  });
}

}  // namespace

RunReference::RunReference(const scenario::Scenario& scenario, const Recorder& recorder)
    : scenario_(scenario), table_(read(scenario)) {
  if (scenario.judge) check_judged(recorder);
}

void RunReference::check_judged(const Recorder& recorder) const {
  const std::string& quantity = scenario_.judge->quantity;
  const auto& columns = recorder.columns();
  if (std::none_of(columns.begin(), columns.end(), [&](const auto& c) { return c.name == quantity; }))
    scenario::refuse(
        scenario_.judge->place,
        "judge.quantity " + quantity + " is not recorded; name it in record.ports, or say --no-reference");
  if (std::find(table_.names.begin(), table_.names.end(), quantity) == table_.names.end())
    scenario::refuse(scenario_.judge->place, "judge.quantity " + quantity +
                                                 " is no column of the reference " +
                                                 scenario_.reference->file.string());
}

void RunReference::compare(const std::filesystem::path& folder) {
  try {
    const auto comparison = scenario::compare(text::TimeTable::read(folder), table_);
    report_ = scenario::text(comparison);
    for (const auto& d : comparison.columns) judge(d);
  } catch (const Error& error) {
    outside_.push_back(error.what());
  }
}

/// The judged quantity has a tolerance of its own, the other columns that of the reference.
void RunReference::judge(const scenario::Difference& d) {
  const bool judged = scenario_.judge && scenario_.judge->quantity == d.column;
  const double tolerance = judged ? scenario_.judge->tolerance : scenario_.reference->tolerance;
  if (!(d.relative <= tolerance)) outside_.push_back(scenario::text(d, tolerance));
  differences_[d.column] = {
      {"relative", d.relative}, {"absolute", d.absolute}, {"time", d.time}, {"tolerance", tolerance}};
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

void RunReference::refuse_outside() const {
  if (!outside_.empty())
    throw RunFailed(fmt::format("{}: the run came to its end, but not within its reference: {}",
                                scenario_.reference->place.text(), fmt::join(outside_, "; ")));
}

}  // namespace tandem::cli
