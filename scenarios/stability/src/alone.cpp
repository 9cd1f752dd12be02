// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "alone.hpp"

#include <limits>

#include "difference.hpp"

namespace tandem::stability {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Alone::Alone(const Trial& trial, int instance, bool linear)
    : subsystem_(trial.subsystem(instance)),
      begin_(trial.begin_time()),
      step_(trial.own_step(instance)),
      linear_(linear),
      x_(static_cast<Index>(trial.states(instance).size())),
      u_(Eigen::Map<const VectorXd>(trial.inputs(instance).data(), subsystem_.info().input_size())) {
  start(u_);
  subsystem_.get_states({x_.data(), static_cast<std::size_t>(x_.size())});
}

std::optional<Linearized> Alone::equations() {
  start(u_);
  return subsystem_.linearized();
}

/// The cube root of rounding, where the errors of central differences meet.
double Alone::change(double about) const {
  constexpr double part = 6e-6;
  return linear_ ? 1.0 : part * std::max(1.0, std::abs(about));
}

MatrixXd Alone::response(double length) {
  MatrixXd columns(states() + outputs(), states() + inputs());
  const VectorXd none = VectorXd::Zero(columns.cols());
  const auto moved = [&](const VectorXd& z) { return after(z, length, constant(z.tail(inputs()))); };
  for (Index k = 0; k < columns.cols(); ++k)
    columns.col(k) = difference(moved, none, k, change(k < states() ? x_[k] : u_[k - states()]));
  return columns;
}

VectorXd Alone::bent(Index input, double length) {
  const auto parabola = [&](const VectorXd& size) {
    auto u = constant(VectorXd::Zero(inputs()));
    u[static_cast<std::size_t>(input)].c[2] = size[0] / (length * length);
    return after(VectorXd::Zero(states() + inputs()), length, u);
  };
  return difference(parabola, VectorXd::Zero(1), 0, change(u_[input]));
}

/// Inputs beside those of the start.
std::vector<Segment> Alone::constant(const VectorXd& change) const {
  std::vector<Segment> pieces;
  for (Index i = 0; i < inputs(); ++i)
    pieces.push_back({std::numeric_limits<double>::infinity(), begin_, {u_[i] + change[i]}});
  return pieces;
}

Samples Alone::start(const VectorXd& u) {
  row_.assign(static_cast<std::size_t>(2 * subsystem_.info().row_size()), 0.0);
  Samples y(row_.data(), subsystem_.info().row_size(), 2);
  subsystem_.initialize(begin_, std::numeric_limits<double>::max(),
                        {u.data(), static_cast<std::size_t>(u.size())}, y);
  return y;
}

VectorXd Alone::after(const VectorXd& change, double length, const std::vector<Segment>& pieces) {
  const VectorXd x = x_ + change.head(states());
  VectorXd u(inputs());
  for (Index i = 0; i < inputs(); ++i) u[i] = pieces[static_cast<std::size_t>(i)].c[0];
  Samples y = start(u);
  subsystem_.set_states({x.data(), static_cast<std::size_t>(x.size())});
  std::vector<Signal> signals;
  for (const Segment& s : pieces) signals.emplace_back(&s, 1, 2);
  subsystem_.advance(begin_ + length, length < step_, signals, y);
  const auto values = y.values(y.size() - 1).first(static_cast<std::size_t>(outputs()));
  VectorXd end(states() + outputs());
  subsystem_.get_states({end.data(), static_cast<std::size_t>(states())});
  std::copy(values.begin(), values.end(), end.data() + states());
  return end;
}

}  // namespace tandem::stability
