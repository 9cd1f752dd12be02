// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "model_exchange.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "equations.hpp"
#include "tandem/classical_steps.hpp"
#include "tandem/error.hpp"
#include "tandem/fixed_step.hpp"

namespace tandem::fmi {
namespace {

constexpr int most_events = 1000;  // within the time of an own step

/// For FixedStep.
class ExchangedModel {
 public:
  explicit ExchangedModel(const std::shared_ptr<Instance>& instance)
      : equations_(instance), row_(row_size()), left_(row_size()), sizes_(row_size()) {
    for (const Port& port : info().outputs)
      held_.insert(held_.end(), static_cast<std::size_t>(port.size), port.held);
    steps_.resize(equations_.size());
    if (integrator()) integrator()->check_fit(equations_.state_names());
  }

  SubsystemInfo info() const { return equations_.running().info(); }
  double own_step() const { return equations_.running().own_step(); }
  bool keeps_state() const { return equations_.running().keeps_state(); }
  bool finished() const { return equations_.finished(); }

  void start(double t, std::span<const double> u0) {
    events_ = 0, events_since_ = t, restart_ = Restart::state;
    std::fill(sizes_.begin(), sizes_.end(), 0.0);
    fmu().within([&] { equations_.start(t, u0); });
  }
  bool step_to_event(OwnStep& s, std::span<const Signal> u);
  bool jump(double t, std::span<const Signal> u);
  void outputs(double* y) const {
    fmu().within([&] { equations_.running().read_row(y); });
  }
  void outputs_before(double* y) const { std::copy(left_.begin(), left_.end(), y); }

  std::optional<std::vector<StateName>> states() const { return equations_.names(); }
  void get_states(std::span<double> x) const { equations_.get(x); }
  void set_states(std::span<const double> x) {
    fmu().within([&] { equations_.put(x); });
    restart_ = Restart::state;
  }

  std::optional<Linearized> linearized() const {
    std::optional<Linearized> found;
    fmu().within([&] { found = equations_.linearized(); });
    return found;
  }

  void write(ByteWriter& to) const {
    equations_.write(to);
    to.put_list(sizes_);
    to.put(events_since_);
    to.put(std::int32_t{events_});
  }
  void read(ByteReader& from) {
    equations_.read(from);
    from.take_list(sizes_);
    events_since_ = from.take<double>();
    events_ = from.take<std::int32_t>();
    restart_ = Restart::state;
  }

 private:
  Instance& fmu() const { return equations_.instance(); }
  std::size_t row_size() const { return static_cast<std::size_t>(info().row_size() - Samples::header); }
  bool move(OwnStep& s);
  double go(double t, double t_end);
  /// With steps of its own; null: the classical method.
  AdaptiveIntegrator* integrator() const {
    return equations_.size() > 0 ? equations_.running().fmu().settings.integrator.get() : nullptr;
  }
  void event(double t);
  bool happen(double t);
  bool has_jumped();

  Equations equations_;
  ClassicalSteps<Equations> steps_;
  std::vector<double> row_, left_;  ///< now, and before an event
  std::vector<double> sizes_;       ///< of the same, the largest at events so far
  std::vector<char> held_;          ///< by output
  double events_since_ = 0.0;
  int events_ = 0;
  std::optional<Restart> restart_ = Restart::state;  ///< of an integrator with steps of its own
};

void ExchangedModel::event(double t) {
  if (t - events_since_ > own_step()) events_since_ = t, events_ = 0;
  if (++events_ > most_events)
    throw Error(ErrorCode::numerical,
                fmt::format("the FMU has more than {} events within an own step, from {} to {} s",
                            most_events, events_since_, t));
  equations_.happen(t);
  restart_ = Restart::event;
}

/// To t_end at the latest.
double ExchangedModel::go(double t, double t_end) {
  AdaptiveIntegrator* own = integrator();
  if (!own) return steps_.advance(equations_, t, t_end, true);
  if (t >= equations_.course_end() && equations_.begin_course(t))
    restart_ = restart_.value_or(Restart::event);
  if (restart_) own->restart(equations_, t, *std::exchange(restart_, std::nullopt));
  return own->advance(equations_, t, std::min(t_end, equations_.course_end()));
}

/// What is held by any difference, all else by one beyond that of locating the event, of its largest value.
bool ExchangedModel::has_jumped() {
  constexpr double smallest = 1e-9;
  equations_.running().read_row(row_.data());
  bool any = false;
  for (std::size_t k = 0; k < row_.size(); ++k) {
    sizes_[k] = std::max({sizes_[k], std::abs(row_[k]), std::abs(left_[k])});
    const double least = k < held_.size() && held_[k] != 0 ? 0.0 : smallest * sizes_[k];
    any = any || !(std::abs(row_[k] - left_[k]) <= least);
  }
  return any;
}

/// True: outputs have jumped with it.
bool ExchangedModel::happen(double t) {
  equations_.running().read_row(left_.data());
  event(t);
  return has_jumped();
}

bool ExchangedModel::step_to_event(OwnStep& s, std::span<const Signal> u) {
  return fmu().within([&] {
    equations_.resume(u);
    return move(s);
  });
}

bool ExchangedModel::move(OwnStep& s) {
  const TimeTolerance tolerance(s.begin);
  const auto waits = [&](double t) {  // for its next event, which may be infinitely far
    return equations_.next_event() > s.end || tolerance.before(t, equations_.next_event());
  };
  double t = s.begin;
  bool due = equations_.discrete_inputs_changed(t);
  while (true) {
    due = due || !waits(t);
    if (due && (happen(t) || finished())) return s.end = t, true;
    if (!tolerance.before(t, s.end)) return false;
    const double begin = t;
    t = go(t, std::min(s.end, equations_.next_event()));
    due = (t > begin && equations_.end_step()) || equations_.changed() >= 0;
    if (!finished()) continue;
    equations_.running().read_row(left_.data());
    return s.end = t, true;
  }
}

/// A jump of an input, of whichever kind, is an event.
bool ExchangedModel::jump(double t, std::span<const Signal> u) {
  return fmu().within([&] {
    equations_.resume(u);
    equations_.running().read_row(left_.data());
    equations_.discrete_inputs_changed(t);
    equations_.evaluate_again(t);
    event(t);
    return has_jumped();
  });
}

}  // namespace

std::unique_ptr<Subsystem> make_model_exchange(std::shared_ptr<Instance> instance) {
  return std::make_unique<FixedStep<ExchangedModel>>(ExchangedModel(instance));
}

}  // namespace tandem::fmi
