// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "kart/kart_model.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tandem/fixed_step.hpp"
#include "tandem/mbs/make_stepper.hpp"
#include "tandem/mbs/state_bytes.hpp"

namespace tandem::kart {
namespace {

constexpr int most = 16;  // variables
using KartVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most, 1>;

/// The model of a FixedStep. A copy is a state that is kept: it shares the model and its stepper.
class DrivenKart {
 public:
  DrivenKart(std::shared_ptr<KartModel> model, const mbs::StepperSettings& settings, double step,
             const mbs::TellOfLimit& tell)
      : model_(std::move(model)),
        stepper_(mbs::make_stepper(*model_, settings)),
        bounds_(std::make_shared<mbs::Bounds>(model_->bounds(), tell)),
        step_(step) {}
  DrivenKart(const DrivenKart& other) { *this = other; }
  DrivenKart& operator=(const DrivenKart& other) {
    if (other.kept_)
      memory_ = other.memory_;
    else
      memory_.clear(), other.stepper_->remember(memory_);
    kept_ = true;
    model_ = other.model_, stepper_ = other.stepper_, bounds_ = other.bounds_;
    state_ = other.state_, step_ = other.step_, torque_ = other.torque_, known_ = other.known_;
    return *this;
  }

  SubsystemInfo info() const {
    SubsystemInfo info = model_->info();
    info.abilities.serializes_state = true;
    return info;
  }
  double own_step() const { return step_; }

  void start(double t, std::span<const double> u0) {
    known_ = !std::isnan(u0[0]);
    model_->torque = torque_ = known_ ? u0[0] : 0.0;
    state_ = model_->standing(t);
    stepper_->start(state_);
    kept_ = false;
  }

  void step(const OwnStep& s, std::span<const Signal> u) {
    if (std::exchange(kept_, false)) stepper_->recall(memory_);
    const double before = std::exchange(torque_, u[0].value(s.begin));
    model_->torque = torque_;
    if (torque_ != before || !known_) stepper_->refresh(state_);
    known_ = true;
    model_->torque = torque_ = u[0].value(s.end);
    stepper_->step(state_, s.length, s.end);
    double values[most];
    model_->watched(state_, values);
    bounds_->look(values, state_.time);
  }

  /// What follows the torque at once is not told before it is known.
  void outputs(double* y) const {
    model_->torque = torque_;
    model_->outputs(state_, y);
    if (known_) return;
    const SubsystemInfo all = model_->info();
    const int size = all.output_size();
    for (const Feedthrough& f : all.feedthrough) y[f.output] = std::numeric_limits<double>::quiet_NaN();
    for (int k = 0; k < size; ++k)
      if (const int order = all.outputs[static_cast<std::size_t>(k)].derivatives; order > 0)
        y[order * size + k] = std::numeric_limits<double>::quiet_NaN();
  }

  /// Of a state that is kept.
  void write(ByteWriter& to) const {
    mbs::write(state_, to);
    to.put_list(memory_);
    to.put(torque_);
    to.put(std::uint8_t{known_});
  }
  void read(ByteReader& from) {
    mbs::read(state_, from);
    memory_ = from.take_list();
    torque_ = from.take<double>();
    known_ = from.take<std::uint8_t>() != 0;
  }

 private:
  std::shared_ptr<KartModel> model_;
  std::shared_ptr<mbs::Stepper> stepper_;
  std::shared_ptr<mbs::Bounds> bounds_;
  double step_ = 0.0, torque_ = 0.0;
  mbs::State state_;
  std::vector<double> memory_;
  bool kept_ = false, known_ = true;
};

mbs::StepperSettings stepper_settings(const KartSettings& s) {
  mbs::StepperSettings to;
  if (s.integrator == "rk4") {
    to.formulation = "penalty";
    to.integrator = "rk4";
  } else if (s.integrator != "newmark") {
    throw Error(ErrorCode::invalid_argument,
                "parameter 'integrator' is '" + s.integrator + "'; allowed is newmark or rk4");
  }
  to.index3.beta = s.beta;
  return to;
}

}  // namespace

KartModel::KartModel(std::vector<std::string> names, std::vector<double> masses) {
  const int n = static_cast<int>(names.size());
  std::vector<std::pair<int, int>> diagonal, all;
  for (int column = 0; column < n; ++column) {
    diagonal.emplace_back(column, column);
    for (int row = 0; row < n; ++row) all.emplace_back(row, column);
  }
  structure_.coordinates = structure_.variables = n;
  structure_.mass = {mbs::Pattern(n, n, diagonal), std::move(masses)};
  structure_.jacobian = mbs::Pattern(n, 0, {});
  structure_.stiffness = mbs::Pattern(n, n, all);
  structure_.symmetric_forces = false;
  structure_.variable_names = std::move(names);
}

/// By central differences; entries stand column by column.
void KartModel::force_derivatives(const double* q, const double* v, double* k, double* c) const {
  const int n = structure_.variables;
  constexpr double by = 1e-6;
  KartVector x(n), plus(n), minus(n);
  for (const auto& [at, other, is_rate, to] : {std::tuple(q, v, false, k), std::tuple(v, q, true, c)}) {
    std::copy_n(at, n, x.data());
    for (int column = 0; column < n; ++column) {
      const double middle = x[column];
      for (auto& [side, sign] : {std::pair<KartVector*, double>(&plus, 1.0), {&minus, -1.0}}) {
        x[column] = middle + sign * by;
        is_rate ? forces(other, x.data(), side->data()) : forces(x.data(), other, side->data());
      }
      x[column] = middle;
      for (int row = 0; row < n; ++row) to[column * n + row] = (minus[row] - plus[row]) / (2.0 * by);
    }
  }
}

mbs::State KartModel::standing(double t) const {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(structure_.variables);
  return {t, zero, zero, zero, Eigen::VectorXd::Zero(0)};
}

std::unique_ptr<Subsystem> make_subsystem(std::shared_ptr<KartModel> model, const KartSettings& settings) {
  if (!(settings.step > 0.0) || !std::isfinite(settings.step))
    throw Error(ErrorCode::invalid_argument, "parameter 'step' is " + std::to_string(settings.step) +
                                                 " s; allowed is a finite number above 0");
  return std::make_unique<FixedStep<DrivenKart>>(
      DrivenKart(std::move(model), stepper_settings(settings), settings.step, settings.tell));
}

}  // namespace tandem::kart
