// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "by_states.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "realise.hpp"

namespace tandem::identification {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// x of the model are the states as parts of their sizes.
class ByStates {
 public:
  explicit ByStates(Prober& prober) : prober_(prober), probe_(prober.probe()), states_(probe_.states()) {
    if (states_ <= 0) return;
    none_ = VectorXd::Zero(states_);
    base_ = probe_.one_step(nullptr, none_);
    size_ = base_.x0.cwiseAbs().cwiseMax(base_.x1.cwiseAbs()).cwiseMax(1.0);
  }

  std::optional<LinearModel> model() {
    const Index inputs = probe_.inputs(), count = states_ + inputs * all_places;
    if (states_ <= 0 || !take_start()) return {};
    x1_.resize(states_, count), y1_.resize(base_.y1.size(), states_);
    for (Index k = 0; k < states_; ++k) {
      const OneStep moved = probe_.one_step(nullptr, size_[k] * VectorXd::Unit(states_, k));
      x1_.col(k) = in_parts(moved), y1_.col(k) = moved.y1 - base_.y1;
    }
    for (int input = 0; input < inputs; ++input)
      for (int place = 0; place < all_places; ++place) {
        const Change change{input, place, prober_.size(input)};
        x1_.col(states_ + input * all_places + place) =
            in_parts(probe_.one_step(&change, none_)) / change.size;
      }
    return whole();
  }

 private:
  /// What inputs change at the start. False: states, too.
  bool take_start() {
    constexpr double rounding = 1e-13;
    const Wanted& wanted = prober_.wanted();
    model_.inputs = Eigen::Map<const VectorXd>(wanted.inputs.data(), probe_.inputs());
    model_.d.resize(base_.y0.size(), probe_.inputs());
    for (int input = 0; input < probe_.inputs(); ++input) {
      const Change change{input, all_places, prober_.size(input)};
      const OneStep moved = probe_.one_step(&change, none_);
      if (!((moved.x0 - base_.x0).isZero(0.0))) return false;
      const VectorXd at_once = moved.y0 - base_.y0;
      const bool is_none = at_once.norm() <= rounding * base_.y0.norm();
      model_.d.col(input) = is_none ? VectorXd::Zero(at_once.size()) : VectorXd(at_once / change.size);
    }
    return true;
  }

  /// By what states are moved after the step, as parts of their sizes.
  VectorXd in_parts(const OneStep& moved) const { return (moved.x1 - base_.x1).cwiseQuotient(size_); }

  LinearModel whole() {
    const Index inputs = probe_.inputs();
    model_.values = prober_.wanted().values;
    model_.step = probe_.step(), model_.linear = true;
    model_.a = x1_.leftCols(states_), model_.b = x1_.rightCols(inputs * all_places);
    model_.c = outputs();
    model_.e = (base_.x1 - base_.x0).cwiseQuotient(size_), model_.y0 = base_.y0;
    model_.s.setZero(states_, inputs);
    model_.residual = left();
    return std::move(model_);
  }

  /// C A = Y, of states that were moved. What no step keeps of a state is in no value after it.
  MatrixXd outputs() const {
    const MatrixXd a = x1_.leftCols(states_).transpose();
    return a.completeOrthogonalDecomposition().solve(y1_.transpose()).transpose();
  }

  double left() const {
    Responses all;
    Realisation r{model_.a, model_.c, MatrixXd(states_, 0), 0.0};
    MatrixXd besides(model_.d.rows(), 0);
    const auto add = [&](MatrixXd response, const VectorXd& x1, const VectorXd& at_once) {
      if (!(response.norm() > 0.0)) return;
      all.push_back(std::move(response));
      r.x1.conservativeResize(states_, r.x1.cols() + 1), r.x1.rightCols(1) = x1;
      besides.conservativeResize(besides.rows(), besides.cols() + 1), besides.rightCols(1) = at_once;
    };
    const MatrixXd& base = prober_.baseline();
    const Index length = base.cols() - 1;
    add(base.rightCols(length) - base.leftCols(length), model_.e, VectorXd::Zero(base.rows()));
    for (int input = 0; input < probe_.inputs(); ++input) {
      MatrixXd moved = prober_.moved(input).rightCols(length) / prober_.size(input);
      moved.col(0) -= model_.d.col(input);
      add(std::move(moved), model_.b.middleCols(input * all_places, all_places).rowwise().sum(),
          model_.d.col(input));
    }
    return all.empty() ? 0.0 : residual(r, all, besides);
  }

  Prober& prober_;
  Probe& probe_;
  const Index states_;
  VectorXd none_, size_;
  OneStep base_;
  MatrixXd x1_, y1_;  ///< what each change makes of states, and each state of values, after a step
  LinearModel model_;
};

}  // namespace

std::optional<LinearModel> model_by_states(Prober& prober) { return ByStates(prober).model(); }

}  // namespace tandem::identification
