// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What each kind of metric tells of a run.
#include <algorithm>
#include <cmath>

#include "one_run.hpp"
#include "tandem/nearest.hpp"
#include "tandem/printable.hpp"

namespace tandem::study {

void RowRunner::OneRun::tell_stability(const Metric& metric) {
  if (metric.of == "spectral_radius")
    return set(metric.name, stability::super_step(scenario_, all_.builtins_).radius());
  if (!stability_) stability_ = stability::stability(scenario_, all_.builtins_);
  if (!stability_->unknown.empty()) throw Error(ErrorCode::not_supported, stability_->unknown);
  const auto off = [&](const stability::Mode& mode) {
    return metric.of == "damping" ? mode.scheme_damping - mode.damping : mode.detuning();
  };
  const auto& states = stability_->states;
  const auto state = std::find(states.begin(), states.end(), metric.state);
  if (!metric.state.empty() && state == states.end())
    refuse(metric.place, "metrics." + metric.name + ".state: " + unknown("state", metric.state, states));
  const auto weight = [&](const stability::Mode& mode) {
    return metric.state.empty() ? std::abs(off(mode)) : mode.parts[state - states.begin()];
  };
  const auto& modes = stability_->modes;
  const auto chosen = std::max_element(modes.begin(), modes.end(),
                                       [&](const auto& a, const auto& b) { return weight(a) < weight(b); });
  if (chosen == modes.end()) return;
  if (chosen->is_kept()) return set(metric.name, off(*chosen));
  result_.note = "the scheme has no mode like that of " + stability_->mostly(*chosen);
}

/// Of a run that failed, too.
void RowRunner::OneRun::judge_otherwise(const Metric& metric) {
  if (metric.otherwise && !result_.metrics.contains(metric.name)) set(metric.name, *metric.otherwise);
}

double RowRunner::OneRun::indicated(const Metric& metric) const {
  const bool defect = metric.kind == Metric::Kind::defect;
  const std::string name = (defect ? "defect(" : "energy(") + metric.of + ")";
  std::vector<std::string> known;
  for (const auto& one : indicators_->connections()) {
    if (defect && one.name == name) return one.largest;
    if (defect) known.push_back(one.name.substr(7, one.name.size() - 8));
  }
  for (const auto& one : indicators_->links()) {
    if (!defect && one.name == name) return one.energy;
    if (!defect) known.push_back(one.name.substr(7, one.name.size() - 8));
  }
  refuse(metric.place,
         "metrics." + metric.name + ": " + unknown(defect ? "input" : "link", metric.of, known));
}

double RowRunner::OneRun::counted(const Metric& metric) const {
  double sum = 0.0;
  for (int i = 0; i < assembly_->topology().size(); ++i) {
    const Effort& effort = assembly_->coordinator().effort(i);
    if (metric.kind == Metric::Kind::exchanges)
      sum += static_cast<double>(effort.exchanges);
    else if (assembly_->topology().name(i) == metric.of)
      sum = static_cast<double>(effort.steps + effort.start_steps);
  }
  return sum;
}

void RowRunner::OneRun::compare(const Metric& metric) {
  const text::TimeTable& run = traces_->of(metric.of);
  const std::string& unit = traces_->unit(metric.of);
  if (metric.against.empty()) return set(metric.name, size_of(metric, run, unit) * scale(metric));
  const ReferenceRun& reference = all_.references_.of(metric.against, all_.table_, row_);
  if (!reference.failure.empty()) return end("failed", reference.failure);
  if (const auto it = reference.units.find(metric.of); it != reference.units.end() && it->second != unit)
    refuse(metric.place, "metrics." + metric.name + ": " + metric.of + " is in '" + unit +
                             "', and in the reference in '" + it->second + "'; allowed is one unit");
  const Judged own = differences_.of(metric, run, reference.tables.at(metric.of), unit);
  set(metric.name, own.value * scale(metric));
  if (metric.window.shift > 0.0) set(metric.name + ".shift", own.shift);
  if (!reference.finer.empty())
    set(metric.name + ".floor",
        differences_.of(metric, reference.tables.at(metric.of), reference.finer.at(metric.of), unit).value *
            scale(metric));
}

void RowRunner::OneRun::compute(const Metric& metric) {
  if (metric.kind == Metric::Kind::coded) return tell(metric);
  if (metric.is_over_time()) {
    const TableOf tables = all_.references_.tables(metric, *traces_, all_.table_, row_);
    return set(metric.name, size_over_time(metric, tables, row_) * scale(metric));
  }
  const FileValues values = with_columns();
  if (is_known(*metric.formula, values)) set(metric.name, value_of(*metric.formula, values) * scale(metric));
}

void RowRunner::OneRun::tell(const Metric& metric) {
  std::string note;
  const text::TimeTable* reference = nullptr;
  if (!metric.against.empty()) {
    const ReferenceRun& made = all_.references_.of(metric.against, all_.table_, row_);
    if (!made.failure.empty()) return end("failed", made.failure);
    reference = &made.tables.at(metric.referred.front().output);
  }
  if (const auto number = coded_.at(metric.name)->value(note, reference))
    set(metric.name, *number * scale(metric));
  if (!note.empty()) result_.note = printable(note, longest_note);
}

}  // namespace tandem::study
