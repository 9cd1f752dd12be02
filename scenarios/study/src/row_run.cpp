// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "row_run.hpp"

#include <algorithm>
#include <cmath>

#include "observers.hpp"
#include "tandem/coordinator/bounds.hpp"
#include "tandem/nearest.hpp"
#include "tandem/printable.hpp"
#include "tandem/scenario/assembly.hpp"
#include "tandem/scenario/steps.hpp"
#include "timing.hpp"

namespace tandem::study {
namespace {

using text::located;

constexpr std::size_t longest_note = 1000;

}  // namespace

/// From a scenario to what it is judged by.
class RowRunner::OneRun {
 public:
  /// finer: its steps are half of what they are.
  OneRun(const RowRunner& all, const FileValues& row, std::vector<std::string> outputs, bool finer = false)
      : all_(all),
        row_(row),
        outputs_(std::move(outputs)),
        finer_(finer),
        scenario_(all.scenes_.of_row(all.table_, row)) {}

  /// False: it is refused.
  bool begin() {
    try {
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
    assembly_->coordinator().observe(&observers_);
    try {
      assembly_->initialize();
    } catch (const Error& error) {
      return end(error.code() == ErrorCode::numerical ? "failed" : "refused", error.what()), false;
    }
    return true;
  }

  /// False: `going` said no.
  bool simulate(const std::function<bool()>& going) {
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

  void judge(const std::function<bool()>& going) {
    try {
      for (const Metric* metric : all_.metrics_) judge(*metric);
      if (result_.status == "ok") judge_status();
      if (result_.status == "ok" && !finer_) judge_orders(going);
    } catch (const Error& error) {
      end("failed", error.what());
    }
  }

  RowResult result() const { return result_; }
  const scenario::Traces& traces() const { return *traces_; }

 private:
  void end(const std::string& status, const std::string& note) {
    result_.status = status, result_.note = printable(note, longest_note);
  }

  void add_coded() {
    for (const Metric* metric : all_.metrics_)
      if (metric->kind == Metric::Kind::coded)
        observers_.add(*(coded_[metric->name] = located(metric->place, [&] { return coded(*metric); })));
  }

  std::unique_ptr<CodedMetric> coded(const Metric& metric) const {
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

  /// Those whose steps are counted, or whose share is told, are there.
  void check_subsystems() const {
    std::vector<std::string> names;
    for (int i = 0; i < assembly_->topology().size(); ++i) names.push_back(assembly_->topology().name(i));
    for (const Metric* metric : all_.metrics_)
      if ((metric->kind == Metric::Kind::steps || metric->kind == Metric::Kind::share) &&
          std::find(names.begin(), names.end(), metric->of) == names.end())
        refuse(metric->place, "metrics.\"" + metric->name + "\": " + unknown("subsystem", metric->of, names));
  }

  /// Of the metric that asks for an output which is not there.
  Place place_named_in(const std::string& sentence) const {
    for (const Metric* metric : all_.metrics_) {
      const std::string& of = metric->of;
      const auto begin = sentence.find('\'') + 1;
      if (of.find(sentence.substr(begin, sentence.find('\'', begin) - begin)) != std::string::npos)
        return metric->place;
    }
    return all_.table_.place;
  }

  void judge(const Metric& metric) {
    if (metric.kind == Metric::Kind::order) return;  // after the verdict
    if (metric.kind == Metric::Kind::exchanges || metric.kind == Metric::Kind::steps)
      set(metric.name, counted(metric));
    else if (metric.is_time() && result_.status == "ok")
      time(metric);
    else if (result_.status == "ok" || metric.kind == Metric::Kind::formula)
      metric.kind == Metric::Kind::output ? compare(metric) : compute(metric);
  }

  void time(const Metric& metric) {
    if (metric.kind == Metric::Kind::share) {
      if (shares_.empty()) shares_ = shares(scenario_, all_.builtins_);
      return set(metric.name, shares_.at(metric.of));
    }
    if (!timing_) timing_ = least_time(scenario_, all_.builtins_, metric.repetitions, judged_);
    if (metric.kind == Metric::Kind::real_time)
      return set(metric.name, (scenario_.stop - scenario_.start) / timing_->seconds);
    set(metric.name, timing_->seconds), set(metric.name + ".processor", timing_->processor);
  }

  /// And the formulas that wait for them.
  void judge_orders(const std::function<bool()>& going) {
    for (const Metric* metric : all_.metrics_)
      if (metric->kind == Metric::Kind::order)
        tell_order(*metric, going);
      else if (metric->kind == Metric::Kind::formula && !result_.metrics.contains(metric->name))
        compute(*metric);
  }

  void tell_order(const Metric& metric, const std::function<bool()>& going) {
    if (!halved_) {
      OneRun finer(all_, row_, outputs_, true);
      if (!finer.begin() || !finer.simulate(going)) return;
      finer.judge(going);
      halved_ = finer.result();
    }
    const auto own = result_.metrics.find(metric.of), half = halved_->metrics.find(metric.of);
    if (halved_->status != "ok" || own == result_.metrics.end() || half == halved_->metrics.end()) return;
    const double order = std::log2(std::get<double>(own->second) / std::get<double>(half->second));
    if (std::isfinite(order)) set(metric.name, order);
  }

  double counted(const Metric& metric) const {
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

  void compare(const Metric& metric) {
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

  void compute(const Metric& metric) {
    if (metric.kind == Metric::Kind::coded) return tell(metric);
    if (metric.is_over_time()) {
      const TableOf tables = all_.references_.tables(metric, *traces_, all_.table_, row_);
      return set(metric.name, size_over_time(metric, tables, row_) * scale(metric));
    }
    const FileValues values = with_columns();
    if (is_known(*metric.formula, values))
      set(metric.name, value_of(*metric.formula, values) * scale(metric));
  }

  void tell(const Metric& metric) {
    std::string note;
    if (const auto number = coded_.at(metric.name)->value(note)) set(metric.name, *number * scale(metric));
    if (!note.empty()) result_.note = printable(note, longest_note);
  }

  double scale(const Metric& metric) const { return metric.scale ? value_of(*metric.scale, row_) : 1.0; }

  void judge_status() {
    const FileValues values = with_columns();
    if (all_.study_.lost && value_of(*all_.study_.lost, values) != 0.0)
      end("lost", all_.study_.lost->text);
    else if (all_.study_.unstable && value_of(*all_.study_.unstable, values) != 0.0)
      end("unstable", all_.study_.unstable->text);
  }

  FileValues with_columns() const {
    FileValues values = row_;
    values.insert(result_.metrics.begin(), result_.metrics.end());
    return values;
  }
  void set(const std::string& name, double value) { result_.metrics[name] = value; }

  const RowRunner& all_;
  const FileValues& row_;
  std::vector<std::string> outputs_;
  bool finer_;
  scenario::Scenario scenario_;
  std::optional<scenario::Assembly> assembly_;
  std::optional<scenario::Traces> traces_;
  std::map<std::string, std::unique_ptr<CodedMetric>> coded_;
  Observers observers_;
  Differences differences_;
  Timing judged_{};  ///< of the run that is judged
  std::optional<Timing> timing_;
  std::map<std::string, double> shares_;
  RowResult result_;
  std::optional<RowResult> halved_;
};

RowRunner::RowRunner(const Study& study, const Table& table, Scenes& scenes, const References& references,
                     const Builtins& builtins, const CodedMetrics& coded)
    : study_(study),
      table_(table),
      scenes_(scenes),
      references_(references),
      builtins_(builtins),
      coded_(coded),
      metrics_(needed_metrics(study, table)),
      outputs_(judged_outputs(metrics_, table)) {}

std::optional<RowResult> RowRunner::run(const FileValues& row, const std::function<bool()>& going) const {
  return table_.search ? search(row, going) : run_once(row, going);
}

std::optional<RowResult> RowRunner::run_once(const FileValues& row,
                                             const std::function<bool()>& going) const {
  OneRun one(*this, row, outputs_);
  if (!one.begin()) return one.result();
  if (!one.simulate(going)) return {};
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
  if (!located(kept.place, [&] { return one.begin(); })) return true;
  if (!one.simulate(going)) return false;
  located(kept.place, [&] { keep(one.traces()); });
  return true;
}

std::string RowRunner::refusal(const FileValues& row) const {
  OneRun one(*this, row, outputs_);
  return one.begin() ? "" : one.result().note;
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
