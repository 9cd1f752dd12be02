// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>
#include <utility>
#include <vector>

#include "tandem/fixed_step.hpp"

namespace tandem {

/// The instants first + k T of a sampled subsystem, multiplied and never accumulated, and where it stands.
class Instants {
 public:
  Instants() = default;
  /// Throws Error as TimeGrid does.
  Instants(double t_start, double first, double period) : time_(t_start), grid_(first, period) {}

  double next() const { return grid_.time(); }
  double after_next() const { return grid_.next(); }
  Clock clock() const { return {time_, grid_.time(), Stop::limit}; }
  /// Moves on to next().
  void step() {
    time_ = grid_.time();
    grid_.step();
  }

  void write(ByteWriter& to) const {
    to.put(time_);
    grid_.write(to);
  }
  void read(ByteReader& from) {
    time_ = from.take<double>();
    grid_.read(from);
  }

 private:
  double time_ = 0.0;
  TimeGrid grid_;
};

/// Makes a model that is written for FixedStep a sampled subsystem, by this word in place of the other:
/// own_step() is its period T [s]. At each instant t_start + offset + k T it gives its outputs, as its state
/// is. Then it steps from there to the next instant on its inputs as they were at this one. Before the first
/// instant the outputs of the model as it was started hold. Model may also have:
/// - `double offset() const`: of the first instant [s], 0 or more.
/// - `double latency() const`: its outputs change so long after each [s].
/// - `void outputs(double* y, std::span<const double> u) const`: at an instant, where an input feeds through.
template <class Model>
class Sampled final : public SavedModels<Model, Instants> {
  using Base = SavedModels<Model, Instants>;
  using Base::model_, Base::place_, Base::info_;

 public:
  explicit Sampled(Model model) : Base(std::move(model)) {
    info_.abilities.sampled = true;
    info_.sampling.period = model_.own_step();
    if constexpr (requires { model_.latency(); }) info_.sampling.latency = model_.latency();
    for (Port& port : info_.outputs) port.held = true;
    values_.resize(static_cast<std::size_t>(info_.input_size()));
    inputs_.resize(values_.size());
  }

  Clock initialize(double t_start, double /*t_stop*/, std::span<const double> u0, Samples& y) override {
    double first = t_start;
    if constexpr (requires { model_.offset(); }) first += model_.offset();
    place_ = Instants(t_start, first, model_.own_step());
    model_.start(t_start, u0);
    model_.outputs(y.append(t_start));
    return place_.clock();
  }

  Clock advance(double, bool, std::span<const Signal>, Samples&) override {
    throw Error(ErrorCode::not_supported, "subsystem '" + info_.name + "' is sampled and takes no own steps");
  }

  Clock sample(double t, SamplePart part, std::span<const double> u, std::span<double> y) override {
    if (part != SamplePart::states) give(u, y.data());
    if (part != SamplePart::outputs) {
      hold(t, u);
      model_.step({t, place_.after_next(), model_.own_step()}, inputs_);
      place_.step();
    }
    return place_.clock();
  }

 private:
  void hold(double t, std::span<const double> u) {
    for (std::size_t k = 0; k < u.size(); ++k) {
      values_[k] = {t, t, {u[k]}};
      inputs_[k] = Signal(&values_[k], 1, 0);
    }
  }
  void give(std::span<const double> u, double* y) const {
    if constexpr (requires { model_.outputs(y, u); })
      model_.outputs(y, u);
    else
      model_.outputs(y);
  }

  std::vector<Segment> values_;  ///< of the inputs, constant
  std::vector<Signal> inputs_;
};

}  // namespace tandem
