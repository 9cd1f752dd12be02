// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "row_run.hpp"

#include <algorithm>

#include "one_run.hpp"

namespace tandem::study {
namespace {

using identification::Models;

std::unique_ptr<Models> models_for(const Table& table) {
  return table.models ? std::make_unique<Models>(Models::Without::refused) : nullptr;
}

}  // namespace

RowRunner::RowRunner(const Study& study, const Table& table, Scenes& scenes, const References& references,
                     const Builtins& builtins, const CodedMetrics& coded)
    : study_(study),
      table_(table),
      scenes_(scenes),
      references_(references),
      models_(models_for(table)),
      builtins_(models_ ? models_->replacing(builtins) : builtins),
      coded_(coded),
      metrics_(needed_metrics(study, table)),
      outputs_(judged_outputs(metrics_, table)) {}

std::optional<RowResult> RowRunner::run(const FileValues& row, const std::function<bool()>& going) const {
  return table_.search ? search(row, going) : run_once(row, going);
}

bool RowRunner::needs_run() const {
  return metrics_.empty() || std::any_of(metrics_.begin(), metrics_.end(), [](const Metric* metric) {
           return metric->kind != Metric::Kind::stability && metric->kind != Metric::Kind::formula;
         });
}

std::optional<RowResult> RowRunner::run_once(const FileValues& row,
                                             const std::function<bool()>& going) const {
  OneRun one(*this, row, outputs_);
  if (!one.begin()) return one.result();
  if (!needs_run())
    one.leave_out();
  else if (!one.simulate(going))
    return {};
  one.judge(going);
  return going() ? std::optional(one.result()) : std::nullopt;
}

bool RowRunner::trace(const FileValues& row, const Kept& kept, const std::function<bool()>& going,
                      const std::function<void(const scenario::Traces&)>& keep) const {
  std::vector<std::string> outputs = kept.outputs;
  for (const std::string& drift : kept.metrics)
    for (const std::string& output : study_.metric(drift).outputs)
      if (!row.contains(output)) outputs.push_back(output);
  OneRun one(*this, row, outputs);
  if (!text::located(kept.place, [&] { return one.begin(); })) return true;
  if (!one.simulate(going)) return false;
  text::located(kept.place, [&] { keep(one.traces()); });
  return true;
}

std::string RowRunner::refusal(const FileValues& row, double* seconds) const {
  const Stopwatch watch;
  OneRun one(*this, row, outputs_);
  if (!one.begin()) return one.result().note;
  const double opening = watch.read().seconds;
  if (seconds)
    *seconds = runs_of_row() * (opening + (needs_run() ? one.expected_seconds() : one.judging_seconds()));
  return "";
}

std::map<std::string, std::string> RowRunner::units(const FileValues& row) const {
  std::map<std::string, std::string> units;
  OneRun one(*this, row, outputs_);
  if (!one.begin()) return units;
  for (const Metric* metric : metrics_)
    units[metric->name] =
        unit_of(*metric, metric->kind == Metric::Kind::output ? one.traces().unit(metric->of) : "");
  return units;
}

}  // namespace tandem::study
