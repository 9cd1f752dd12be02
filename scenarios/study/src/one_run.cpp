// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "one_run.hpp"

#include <algorithm>
#include <cmath>

#include "expected_time.hpp"
#include "tandem/coordinator/bounds.hpp"
#include "tandem/nearest.hpp"
#include "tandem/printable.hpp"
#include "tandem/scenario/steps.hpp"
#include "tandem/stability/fast_period.hpp"

namespace tandem::study {
namespace {

using text::located;

constexpr double patience = 0.1;  ///< [s] of a run, to tell what the whole will take

}  // namespace

RowRunner::OneRun::OneRun(const RowRunner& all, const FileValues& row, std::vector<std::string> outputs,
                          bool finer)
    : all_(all),
      row_(row),
      outputs_(std::move(outputs)),
      finer_(finer),
      scenario_(all.scenes_.of_row(all.table_, row)) {}

bool RowRunner::OneRun::begin() {
  try {
    scenario_ = stability::with_fast_period(std::move(scenario_), all_.builtins_);
    all_.scenes_.scale_steps(scenario_, row_);
    if (finer_) scenario::scale_steps(scenario_, all_.builtins_, 0.5);
    assembly_.emplace(scenario_, all_.builtins_);
  } catch (const Error& error) {
    return end("refused", error.what()), false;
  }
  check_subsystems();
  located([this](const std::string& sentence) { return place_named_in(sentence); },
          [this] { traces_.emplace(assembly_->topology(), outputs_, "the run"); });
  observers_.add(*traces_);
  add_coded();
  const auto is_indicator = [](const Metric* metric) { return metric->is_indicator(); };
  if (std::any_of(all_.metrics_.begin(), all_.metrics_.end(), is_indicator)) {
    indicators_ = assembly_->indicators();
    if (!indicators_) return end("refused", "record.indicators is off, and a metric is of them"), false;
    observers_.add(*indicators_);
    for (const Metric* metric : all_.metrics_)
      if (metric->is_indicator()) indicated(*metric);  // is there
  }
  assembly_->coordinator().observe(&observers_);
  try {
    assembly_->initialize();
  } catch (const Error& error) {
    return end(error.code() == ErrorCode::numerical ? "failed" : "refused", error.what()), false;
  }
  check_states();
  return true;
}

/// Of one that keeps its states to itself no name is known before its model is found.
void RowRunner::OneRun::check_states() const {
  std::vector<std::string> known;
  for (int i = 0; i < assembly_->topology().size(); ++i) {
    const auto states = assembly_->subsystem(i).states();
    if (!states) return;
    for (const StateName& state : *states) known.push_back(assembly_->topology().name(i) + "." + state.name);
  }
  for (const Metric* metric : all_.metrics_)
    if (!metric->state.empty() && std::find(known.begin(), known.end(), metric->state) == known.end())
      refuse(metric->place, "metrics." + metric->name + ".state: " + unknown("state", metric->state, known));
}

bool RowRunner::OneRun::simulate(const std::function<bool()>& going) {
  try {
    const Stopwatch watch;
    while (assembly_->coordinator().round()) {
      observers_.between_rounds();
      if (!going()) return false;
    }
    judged_ = watch.read();
    end("ok", "");
  } catch (const Diverged& error) {
    end("lost", error.what());
  } catch (const Error& error) {
    end("failed", error.what());
  }
  return true;
}

double RowRunner::OneRun::expected_seconds() {
  return study::expected_seconds(*assembly_, scenario_.start, scenario_.stop, patience);
}

double RowRunner::OneRun::judging_seconds() {
  const Stopwatch watch;
  leave_out();
  judge([] { return true; });
  return watch.read().processor;
}

void RowRunner::OneRun::judge(const std::function<bool()>& going) {
  try {
    for (const Metric* metric : all_.metrics_) judge(*metric), judge_otherwise(*metric);
    if (result_.status == "ok") judge_status();
    if (result_.status == "ok" && !finer_) judge_orders(going);
  } catch (const Error& error) {
    end("failed", error.what());
  }
}

void RowRunner::OneRun::end(const std::string& status, const std::string& note) {
  result_.status = status, result_.note = printable(note, longest_note);
}

void RowRunner::OneRun::add_coded() {
  for (const Metric* metric : all_.metrics_)
    if (metric->kind == Metric::Kind::coded)
      observers_.add(*(coded_[metric->name] = located(metric->place, [&] { return coded(*metric); })));
}

std::unique_ptr<CodedMetric> RowRunner::OneRun::coded(const Metric& metric) const {
  const auto it = all_.coded_.find(metric.of);
  if (it == all_.coded_.end()) {
    std::vector<std::string> known;
    for (const auto& [name, make] : all_.coded_) known.push_back(name);
    throw Error(ErrorCode::invalid_argument, unknown("builtin metric", metric.of, known));
  }
  Parameters parameters;
  for (const Given& with : metric.with) parameters.set(with.name, with.with(row_));
  auto made = it->second(assembly_->coordinator(), {scenario_.start, scenario_.stop}, parameters);
  parameters.refuse_unused("builtin metric '" + metric.of + "'");
  return made;
}

void RowRunner::OneRun::check_subsystems() const {
  std::vector<std::string> names;
  for (int i = 0; i < assembly_->topology().size(); ++i) names.push_back(assembly_->topology().name(i));
  for (const Metric* metric : all_.metrics_)
    if ((metric->kind == Metric::Kind::steps || metric->kind == Metric::Kind::share) &&
        std::find(names.begin(), names.end(), metric->of) == names.end())
      refuse(metric->place, "metrics.\"" + metric->name + "\": " + unknown("subsystem", metric->of, names));
}

Place RowRunner::OneRun::place_named_in(const std::string& sentence) const {
  for (const Metric* metric : all_.metrics_) {
    const std::string& of = metric->of;
    const auto begin = sentence.find('\'') + 1;
    if (of.find(sentence.substr(begin, sentence.find('\'', begin) - begin)) != std::string::npos)
      return metric->place;
  }
  return all_.table_.place;
}

void RowRunner::OneRun::judge(const Metric& metric) {
  if (metric.kind == Metric::Kind::order) return;  // after the verdict
  if (metric.kind == Metric::Kind::stability)
    tell_stability(metric);
  else if (metric.kind == Metric::Kind::exchanges || metric.kind == Metric::Kind::steps)
    set(metric.name, counted(metric));
  else if (metric.is_indicator())
    set(metric.name, indicated(metric) * scale(metric));
  else if (metric.is_time()) {
    if (result_.status == "ok" && !finer_) time(metric);
  } else if (result_.status == "ok" || metric.kind == Metric::Kind::formula)
    metric.kind == Metric::Kind::output ? compare(metric) : compute(metric);
}

void RowRunner::OneRun::time(const Metric& metric) {
  if (metric.kind == Metric::Kind::share) {
    if (shares_.empty()) shares_ = shares(scenario_, all_.builtins_);
    return set(metric.name, shares_.at(metric.of));
  }
  if (!timing_) timing_ = least_time(scenario_, all_.builtins_, metric.repetitions, judged_);
  if (metric.kind == Metric::Kind::real_time)
    return set(metric.name, (scenario_.stop - scenario_.start) / timing_->seconds);
  set(metric.name, timing_->seconds), set(metric.name + ".processor", timing_->processor);
}

void RowRunner::OneRun::judge_orders(const std::function<bool()>& going) {
  for (const Metric* metric : all_.metrics_)
    if (metric->kind == Metric::Kind::order)
      tell_order(*metric, going);
    else if (metric->kind == Metric::Kind::formula && !result_.metrics.contains(metric->name))
      compute(*metric);
}

void RowRunner::OneRun::tell_order(const Metric& metric, const std::function<bool()>& going) {
  if (!halved_) {
    OneRun finer(all_, row_, outputs_, true);
    if (finer.begin()) {
      if (!finer.simulate(going)) return;
      finer.judge(going);
    }
    halved_ = finer.result();
    if (halved_->status != "ok")
      result_.note =
          printable("with half the steps it is " + halved_->status + ": " + halved_->note, longest_note);
  }
  const auto own = result_.metrics.find(metric.of), half = halved_->metrics.find(metric.of);
  if (halved_->status != "ok" || own == result_.metrics.end() || half == halved_->metrics.end()) return;
  const double order = std::log2(std::get<double>(own->second) / std::get<double>(half->second));
  if (std::isfinite(order)) set(metric.name, order);
}

void RowRunner::OneRun::judge_status() {
  const FileValues values = with_columns();
  if (all_.study_.lost && value_of(*all_.study_.lost, values) != 0.0)
    end("lost", all_.study_.lost->text);
  else if (all_.study_.unstable && value_of(*all_.study_.unstable, values) != 0.0)
    end("unstable", all_.study_.unstable->text);
}

FileValues RowRunner::OneRun::with_columns() const {
  FileValues values = row_;
  values.insert(result_.metrics.begin(), result_.metrics.end());
  return values;
}

}  // namespace tandem::study
