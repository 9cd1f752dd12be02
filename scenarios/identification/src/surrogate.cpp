// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/identification/surrogate.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "part_step.hpp"
#include "tandem/error.hpp"
#include "tandem/fixed_step.hpp"

namespace tandem::identification {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr Index looks = static_cast<Index>(places.size());

/// The model of a FixedStep. A copy is a state that is kept: it shares the linear model.
class SurrogateModel {
 public:
  SurrogateModel(LinearModel model, const SubsystemInfo& of)
      : machine_(std::make_shared<Machine>(std::move(model), of)),
        u_(linear().b.cols()),
        end_(linear().inputs.size()) {
    machine_->info.abilities = {};
    machine_->feeds_through = linear().d.size() > 0 && linear().d.cwiseAbs().maxCoeff() > 0.0;
  }

  SubsystemInfo info() const { return machine_->info; }
  double own_step() const { return linear().step; }

  void start(double, std::span<const double> u0) {
    end_ = Eigen::Map<const VectorXd>(u0.data(), end_.size()) - linear().inputs;
    x_ = linear().s * end_.unaryExpr([](double d) { return std::isnan(d) ? 0.0 : d; });
  }

  /// A step is whole where it has the length of one, but for rounding.
  void step(const OwnStep& s, std::span<const Signal> u) {
    constexpr double rounding = 1e-9;
    read(s, u);
    const bool is_whole = std::abs(s.length - own_step()) <= rounding * own_step();
    const PartStep* const part = is_whole ? nullptr : &part_of(s.length);
    next_.noalias() = (part ? part->a : linear().a) * x_;
    next_.noalias() += (part ? part->b : linear().b) * u_;
    next_ += part ? part->e : linear().e;
    std::swap(x_, next_);
  }

  bool jump(double t, std::span<const Signal> u) {
    for (Index i = 0; i < end_.size(); ++i)
      end_[i] = u[static_cast<std::size_t>(i)].value(t) - linear().inputs[i];
    return machine_->feeds_through;
  }

  /// A value that follows an unknown input at once is not known either.
  void outputs(double* y) const {
    std::fill_n(y, machine_->info.row_size() - Samples::header, 0.0);
    for (Index k = 0; k < linear().c.rows(); ++k) {
      double value = linear().y0[k] + linear().c.row(k).dot(x_);
      for (Index i = 0; i < end_.size(); ++i)
        if (linear().d(k, i) != 0.0) value += linear().d(k, i) * end_[i];
      y[linear().values[static_cast<std::size_t>(k)]] = value;
    }
  }

  std::optional<std::vector<StateName>> states() const {
    std::vector<StateName> names;
    for (Index k = 0; k < linear().order(); ++k) names.push_back({"state " + std::to_string(k + 1), ""});
    return names;
  }
  void get_states(std::span<double> x) const { std::copy(x_.begin(), x_.end(), x.begin()); }
  void set_states(std::span<const double> x) { std::copy(x.begin(), x.end(), x_.begin()); }

 private:
  struct Machine {
    Machine(LinearModel of, const SubsystemInfo& ports) : model(std::move(of)), parts(model), info(ports) {}
    LinearModel model;
    PartSteps parts;
    SubsystemInfo info;
    bool feeds_through = false;
  };
  const LinearModel& linear() const { return machine_->model; }

  void read(const OwnStep& s, std::span<const Signal> u) {
    for (Index i = 0; i < end_.size(); ++i) {
      const Signal& input = u[static_cast<std::size_t>(i)];
      for (Index j = 0; j < looks; ++j) {
        const double t = j + 1 == looks ? s.end : s.begin + places[static_cast<std::size_t>(j)] * s.length;
        u_[i * looks + j] = input.value(t) - linear().inputs[i];
      }
      end_[i] = u_[i * looks + looks - 1];
    }
  }

  const PartStep& part_of(double length) {
    if (!machine_->parts.exist())
      throw Error(ErrorCode::not_supported,
                  "the linear model of subsystem '" + machine_->info.name +
                      "' has no motion in continuous time, so no step of it is cut");
    return machine_->parts.of(length);
  }

  std::shared_ptr<Machine> machine_;
  VectorXd x_, next_;
  VectorXd u_, end_;  ///< inputs at all places of a step, and at its end
};

}  // namespace

std::unique_ptr<Subsystem> make_surrogate(LinearModel model, const SubsystemInfo& of) {
  return std::make_unique<FixedStep<SurrogateModel>>(SurrogateModel(std::move(model), of));
}

}  // namespace tandem::identification
