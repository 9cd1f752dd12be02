// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/identification/surrogate.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "part_step.hpp"
#include "sampled_surrogate.hpp"
#include "tandem/error.hpp"
#include "tandem/fixed_step.hpp"

namespace tandem::identification {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Where a step looks at an input.
struct Look {
  std::size_t input;
  double part;    ///< of the step
  double before;  ///< what the model takes off
};

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A step as one product: x+ = M [x; inputs where it looks; 1].
struct Packed {
  Packed() = default;
  /// Without the columns that are 0: most methods look at few places.
  Packed(const LinearModel& model, const MatrixXd& a, const MatrixXd& b, const VectorXd& e) {
    const Index n = a.rows(), all = static_cast<Index>(places.size());
    m.resize(n, n + b.cols() + 1);
    m.leftCols(n) = a;
    for (Index k = 0; k < b.cols(); ++k) {
      if (b.col(k).isZero(0.0)) continue;
      m.col(n + static_cast<Index>(looks.size())) = b.col(k);
      looks.push_back({static_cast<std::size_t>(k / all), places[static_cast<std::size_t>(k % all)],
                       model.inputs[k / all]});
    }
    m.conservativeResize(n, n + static_cast<Index>(looks.size()) + 1);
    m.rightCols(1) = e;
  }
  RowMajor m;
  std::vector<Look> looks;
};

/// The model of a FixedStep. A copy is a state that is kept: it shares the linear model.
class SurrogateModel {
 public:
  SurrogateModel(LinearModel model, const SubsystemInfo& of)
      : machine_(std::make_shared<Machine>(std::move(model), of)),
        z_(linear().order() + linear().b.cols() + 1),
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
    const bool is_whole = std::abs(s.length - own_step()) <= rounding * own_step();
    const Packed& packed = is_whole ? machine_->whole : part_of(s.length);
    double* z = std::copy(x_.begin(), x_.end(), z_.data());
    for (const Look& look : packed.looks)
      *z++ = u[look.input].value(look.part == 1.0 ? s.end : s.begin + look.part * s.length) - look.before;
    *z = 1.0;
    const double* row = packed.m.data();
    for (double& x : x_) x = std::inner_product(z_.data(), z + 1, row, 0.0), row += packed.m.cols();
    if (machine_->feeds_through) read(s.end, u);
  }

  bool jump(double t, std::span<const Signal> u) {
    if (machine_->feeds_through) read(t, u);
    return machine_->feeds_through;
  }

  /// A value that follows an unknown input at once is not known either.
  void outputs(double* y) const {
    const Machine& machine = *machine_;
    const LinearModel& model = machine.model;
    if (!machine.gives_all) std::fill_n(y, machine.info.row_size() - Samples::header, 0.0);
    const double *c = machine.c.data(), *x = x_.data();
    for (Index k = 0, n = x_.size(); k < machine.c.rows(); ++k, c += n) {
      double value = std::inner_product(c, c + n, x, model.y0[k]);
      for (Index i = 0; machine.feeds_through && i < end_.size(); ++i)
        if (model.d(k, i) != 0.0) value += model.d(k, i) * end_[i];
      y[model.values[static_cast<std::size_t>(k)]] = value;
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
    Machine(LinearModel of, const SubsystemInfo& ports)
        : model(std::move(of)),
          whole(model, model.a, model.b, model.e),
          c(model.c),
          info(ports),
          gives_all(static_cast<int>(model.values.size()) == ports.row_size() - Samples::header) {}
    LinearModel model;
    Packed whole;
    RowMajor c;
    std::optional<PartSteps> parts;  ///< once a step is cut
    Packed part;
    double part_length = 0.0;
    SubsystemInfo info;
    bool feeds_through = false;
    const bool gives_all;  ///< each value of a row
  };
  const LinearModel& linear() const { return machine_->model; }

  void read(double t, std::span<const Signal> u) {
    for (Index i = 0; i < end_.size(); ++i)
      end_[i] = u[static_cast<std::size_t>(i)].value(t) - linear().inputs[i];
  }

  const Packed& part_of(double length) {
    if (!machine_->parts) machine_->parts.emplace(linear());
    if (!machine_->parts->exist())
      throw Error(ErrorCode::not_supported,
                  "the linear model of subsystem '" + machine_->info.name +
                      "' has no motion in continuous time, so no step of it is cut");
    if (machine_->part_length != length) {
      const PartStep part = machine_->parts->of(length);
      machine_->part = Packed(linear(), part.a, part.b, part.e), machine_->part_length = length;
    }
    return machine_->part;
  }

  std::shared_ptr<Machine> machine_;
  VectorXd x_, z_;
  VectorXd end_;  ///< inputs at the end of a step
};

}  // namespace

std::optional<LinearModel> with_step(const LinearModel& model, double step) {
  const PartSteps parts(model);
  if (!parts.exist()) return {};
  LinearModel other = model;
  const PartStep part = parts.of(step);
  other.a = part.a, other.b = part.b, other.e = part.e, other.step = step;
  return other;
}

std::unique_ptr<Subsystem> make_surrogate(LinearModel model, const SubsystemInfo& of) {
  if (of.abilities.sampled) return make_sampled_surrogate(std::move(model), of);
  return std::make_unique<FixedStep<SurrogateModel>>(SurrogateModel(std::move(model), of));
}

}  // namespace tandem::identification
