// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "undivided.hpp"

#include <Eigen/Eigenvalues>
#include <limits>
#include <unsupported/Eigen/MatrixFunctions>

#include "tandem/error.hpp"

namespace tandem::stability {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// One subsystem alone.
class Alone {
 public:
  Alone(const Trial& trial, int instance, bool linear)
      : subsystem_(trial.subsystem(instance)),
        begin_(trial.begin_time()),
        step_(trial.own_step(instance)),
        linear_(linear),
        x_(VectorXd::Zero(static_cast<Index>(subsystem_.info().states.size()))) {
    start(VectorXd::Zero(inputs()));
    if (!linear) subsystem_.get_states({x_.data(), static_cast<std::size_t>(x_.size())});
  }

  Index states() const { return x_.size(); }
  Index inputs() const { return subsystem_.info().input_size(); }
  bool lands() const { return subsystem_.info().abilities.lands; }
  double step() const { return step_; }

  /// Columns [A B; C' D'] of a step: states and outputs at its end by states at its begin and constant inputs.
  /// Central differences, of which one that is linear can take large ones.
  MatrixXd response(double length) {
    MatrixXd columns(states() + subsystem_.info().output_size(), states() + inputs());
    for (Index k = 0; k < columns.cols(); ++k) {
      constexpr double part = 6e-6;
      const double change = linear_ ? 1.0 : part * std::max(1.0, k < states() ? std::abs(x_[k]) : 0.0);
      const VectorXd z = change * VectorXd::Unit(columns.cols(), k);
      columns.col(k) = (after(z, length) - after(-z, length)) / (2.0 * change);
    }
    return columns;
  }

 private:
  Samples start(const VectorXd& u) {
    row_.assign(static_cast<std::size_t>(2 * subsystem_.info().row_size()), 0.0);
    Samples y(row_.data(), subsystem_.info().row_size(), 2);
    subsystem_.initialize(begin_, std::numeric_limits<double>::max(),
                          {u.data(), static_cast<std::size_t>(u.size())}, y);
    return y;
  }

  VectorXd after(const VectorXd& change, double length) {
    const VectorXd u = change.tail(inputs()), x = x_ + change.head(states());
    Samples y = start(u);
    subsystem_.set_states({x.data(), static_cast<std::size_t>(x.size())});
    std::vector<Segment> constant;
    for (const double value : u)
      constant.push_back({std::numeric_limits<double>::infinity(), begin_, {value}});
    std::vector<Signal> signals;
    for (const Segment& s : constant) signals.emplace_back(&s, 1, 0);
    subsystem_.advance(begin_ + length, length < step_, signals, y);
    const auto values =
        y.values(y.size() - 1).first(static_cast<std::size_t>(subsystem_.info().output_size()));
    VectorXd end(states() + static_cast<Index>(values.size()));
    subsystem_.get_states({end.data(), static_cast<std::size_t>(states())});
    std::copy(values.begin(), values.end(), end.data() + states());
    return end;
  }

  Subsystem& subsystem_;
  double begin_, step_;
  bool linear_;
  VectorXd x_;  ///< about which it is looked at
  std::vector<double> row_;
};

/// [G b] of a step of this length.
MatrixXd rates_of(const MatrixXd& response, Index states, double length) {
  const Index size = response.cols();
  MatrixXd moved = MatrixXd::Identity(size, size);
  moved.topRows(states) = response.topRows(states);
  return moved.log().topRows(states) / length;
}

double largest_turn(const MatrixXd& response, Index states) {
  return states == 0 ? 0.0
                     : Eigen::EigenSolver<MatrixXd>(response.topLeftCorner(states, states), false)
                           .eigenvalues()
                           .unaryExpr([](std::complex<double> l) { return std::abs(std::arg(l)); })
                           .maxCoeff();
}

/// Without the error of a method of any order: the order is seen in how the last difference follows the one before.
MatrixXd extrapolated(const MatrixXd& whole, const MatrixXd& half, const MatrixXd& quarter) {
  constexpr double rounding = 1e-9;
  const double before = (whole - half).norm(), last = (half - quarter).norm();
  if (last <= rounding * quarter.norm() || last >= before) return quarter;
  return quarter + (quarter - half) / (before / last - 1.0);
}

/// G, b, C and D of one.
struct Linear {
  MatrixXd g, b, c, d;
};

Linear linear(const Trial& trial, int instance, bool is_linear) {
  constexpr double most_turn = 0.5;
  constexpr int most_halves = 20;
  Alone one(trial, instance, is_linear);
  const Index n = one.states();
  double length = one.step();
  MatrixXd response = one.response(length);
  if (one.lands())
    for (int k = 0; k < most_halves && largest_turn(response, n) > most_turn; ++k)
      response = one.response(length *= 0.5);
  MatrixXd rates = rates_of(response, n, length);
  if (one.lands())
    rates = extrapolated(rates, rates_of(one.response(length / 2.0), n, length / 2.0),
                         rates_of(one.response(length / 4.0), n, length / 4.0));
  // outputs are of the states at the end: [C' D'] = C [A B] + [0 D]
  const MatrixXd c =
      response.bottomLeftCorner(response.rows() - n, n) * response.topLeftCorner(n, n).fullPivLu().inverse();
  const MatrixXd d = response.bottomRightCorner(response.rows() - n, one.inputs()) -
                     c * response.topRightCorner(n, one.inputs());
  return {rates.leftCols(n), rates.rightCols(one.inputs()), c, d};
}

/// Puts a block on the diagonal.
void append(MatrixXd& to, const MatrixXd& block) {
  MatrixXd all = MatrixXd::Zero(to.rows() + block.rows(), to.cols() + block.cols());
  all.topLeftCorner(to.rows(), to.cols()) = to;
  all.bottomRightCorner(block.rows(), block.cols()) = block;
  to = std::move(all);
}

/// u = L y.
MatrixXd connections(const Topology& topology) {
  std::vector<Index> input{0}, output{0};
  for (int i = 0; i < topology.size(); ++i) {
    input.push_back(input.back() + topology.info(i).input_size());
    output.push_back(output.back() + topology.info(i).output_size());
  }
  MatrixXd l = MatrixXd::Zero(input.back(), output.back());
  for (const Line& line : topology.lines())
    l(input[static_cast<std::size_t>(line.reader)] + line.input,
      output[static_cast<std::size_t>(line.source)] + line.output) += line.gain;
  return l;
}

}  // namespace

Undivided undivided(const Trial& trial, bool is_linear) {
  Undivided all;
  Linear sum;
  for (int i = 0; i < trial.topology().size(); ++i) {
    const Linear one = linear(trial, i, is_linear);
    append(sum.g, one.g), append(sum.b, one.b), append(sum.c, one.c), append(sum.d, one.d);
    for (const StateName& state : trial.topology().info(i).states)
      all.names.push_back(trial.topology().name(i) + '.' + state.name);
  }
  const MatrixXd l = connections(trial.topology());
  const Eigen::FullPivLU<MatrixXd> loop(MatrixXd::Identity(l.rows(), l.rows()) - l * sum.d);
  if (!loop.isInvertible())
    throw Error(ErrorCode::not_supported, "the connections make a loop at once that has no solution");
  all.rates = sum.g + sum.b * loop.solve(l * sum.c);
  return all;
}

}  // namespace tandem::stability
