// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "sampled_surrogate.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tandem/sampled.hpp"

namespace tandem::identification {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// The model of a Sampled. A copy is a state that is kept.
class SampledModel {
 public:
  SampledModel(const LinearModel& model, const SubsystemInfo& of)
      : model_(std::make_shared<const LinearModel>(model)), info_(of), x_(VectorXd::Zero(model.order())) {
    info_.abilities = {};
  }

  SubsystemInfo info() const { return info_; }
  double own_step() const { return model_->step; }
  double offset() const { return model_->offset; }
  double latency() const { return info_.sampling.latency; }

  void start(double, std::span<const double> u0) {
    x_.setZero();
    for (Index i = 0; i < model_->inputs.size(); ++i)
      if (!std::isnan(u0[at(i)])) x_ += model_->s.col(i) * (u0[at(i)] - model_->inputs[i]);
  }
  void outputs(double* y) const { give(model_->before, y); }
  void outputs(double* y, std::span<const double> u) const {
    VectorXd values = model_->y0 + model_->c * x_;
    for (Index i = 0; i < model_->inputs.size(); ++i)
      values += model_->d.col(i) * (u[at(i)] - model_->inputs[i]);
    give(values, y);
  }
  void step(const OwnStep& s, std::span<const Signal> u) {
    x_ = (model_->a * x_ + model_->e).eval();
    for (Index i = 0; i < model_->inputs.size(); ++i)
      x_ += model_->b.col(i * static_cast<Index>(places.size())) *
            (u[at(i)].value(s.begin) - model_->inputs[i]);
  }

  std::optional<std::vector<StateName>> states() const {
    std::vector<StateName> names;
    for (Index k = 0; k < model_->order(); ++k) names.push_back({"state " + std::to_string(k + 1), ""});
    return names;
  }
  void get_states(std::span<double> x) const { std::copy(x_.begin(), x_.end(), x.begin()); }
  void set_states(std::span<const double> x) { std::copy(x.begin(), x.end(), x_.begin()); }

 private:
  static std::size_t at(Index k) { return static_cast<std::size_t>(k); }
  void give(const VectorXd& values, double* y) const {
    std::fill_n(y, info_.output_size(), 0.0);
    for (Index k = 0; k < values.size(); ++k) y[model_->values[at(k)]] = values[k];
  }

  std::shared_ptr<const LinearModel> model_;
  SubsystemInfo info_;
  VectorXd x_;
};

}  // namespace

std::unique_ptr<Subsystem> make_sampled_surrogate(LinearModel model, const SubsystemInfo& of) {
  return std::make_unique<Sampled<SampledModel>>(SampledModel(model, of));
}

}  // namespace tandem::identification
