// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "linear_side.hpp"

#include <Eigen/Eigenvalues>
#include <unsupported/Eigen/MatrixFunctions>

#include "alone.hpp"
#include "tandem/error.hpp"

namespace tandem::stability {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

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

/// Without the error of a method of any order: the order is seen in how the last difference follows the one
/// before.
MatrixXd extrapolated(const MatrixXd& whole, const MatrixXd& half, const MatrixXd& quarter) {
  constexpr double rounding = 1e-9;
  const double before = (whole - half).norm(), last = (half - quarter).norm();
  if (last <= rounding * quarter.norm() || last >= before) return quarter;
  return quarter + (quarter - half) / (before / last - 1.0);
}

MatrixXd by_rows(const std::vector<double>& values, Index rows, Index columns) {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const Rows>(values.data(), rows, columns);
}

/// As the subsystem says itself, if what it says moves as its steps do: these have the error of their method.
LinearSide said(const std::string& name, const Linearized& known, const Alone& alone,
                const MatrixXd& response, double length) {
  constexpr double most = 0.05;
  const Index n = alone.states(), inputs = alone.inputs();
  const LinearSide one{by_rows(known.a, n, n), by_rows(known.b, n, inputs),
                       by_rows(known.c, alone.outputs(), n), by_rows(known.d, alone.outputs(), inputs)};
  MatrixXd rates = MatrixXd::Zero(n + inputs, n + inputs);
  rates.topRows(n) << one.g, one.b;
  const MatrixXd moved = MatrixXd(length * rates).exp().topRows(n);
  if (!((moved - response.topRows(n)).norm() <= most * moved.norm()))
    throw Error(ErrorCode::numerical,
                "subsystem '" + name +
                    "' moves otherwise than its directional derivatives say, over a step of " +
                    std::to_string(length) + " s from the start");
  return one;
}

/// What the model makes of that input, in parts of the length: chain q0 = q, q0' = q1, q1' = q2 = 2.
VectorXd bent(const LinearSide& one, Index input, double length) {
  const Index n = one.g.rows();
  MatrixXd rates = MatrixXd::Zero(n + 3, n + 3);
  rates.topLeftCorner(n, n) = length * one.g;
  rates.col(n).head(n) = length * one.b.col(input);
  rates(n, n + 1) = rates(n + 1, n + 2) = 1.0;
  VectorXd end(n + one.c.rows());
  end.head(n) = 2.0 * MatrixXd(rates.exp()).col(n + 2).head(n);
  end.tail(one.c.rows()) = one.c * end.head(n) + one.d.col(input);
  return end;
}

/// What follows rates of an input moves by far more than a model of constant inputs: rates are 1 / length and
/// more. By a few times more moves what looks at the ends of a step alone.
void check_rates(const std::string& name, Alone& alone, const LinearSide& one, double length) {
  constexpr double most = 10.0, rounding = 1e-9;
  const Index n = one.g.rows();
  const auto far = [&](const VectorXd& found, const VectorXd& expected) {
    return found.norm() > most * expected.norm() + rounding;
  };
  for (Index i = 0; i < alone.inputs(); ++i) {
    const VectorXd found = alone.bent(i, length), expected = bent(one, i, length);
    if (far(found.head(n), expected.head(n)) || far(found.tail(one.c.rows()), expected.tail(one.c.rows())))
      throw Error(
          ErrorCode::not_supported,
          "subsystem '" + name + "' follows rates of its inputs, of which constant inputs tell nothing");
  }
}

}  // namespace

LinearSide linear_side(const Trial& trial, int instance, bool is_linear) {
  constexpr double most_turn = 0.5;
  constexpr int most_halves = 20;
  Alone one(trial, instance, is_linear);
  const std::string& name = trial.topology().name(instance);
  const Index n = one.states();
  double length = one.step();
  MatrixXd response = one.response(length);
  if (n == 0) {
    const LinearSide still{MatrixXd(0, 0), MatrixXd(0, one.inputs()), MatrixXd(response.rows(), 0), response};
    return check_rates(name, one, still, length), still;
  }
  if (one.lands())
    for (int k = 0; k < most_halves && largest_turn(response, n) > most_turn; ++k)
      response = one.response(length *= 0.5);
  if (const auto known = one.equations()) return said(name, *known, one, response, length);
  MatrixXd rates = rates_of(response, n, length);
  if (one.lands())
    rates = extrapolated(rates, rates_of(one.response(length / 2.0), n, length / 2.0),
                         rates_of(one.response(length / 4.0), n, length / 4.0));
  // outputs are of the states at the end: [C' D'] = C [A B] + [0 D]
  const MatrixXd c =
      response.bottomLeftCorner(response.rows() - n, n) * response.topLeftCorner(n, n).fullPivLu().inverse();
  const MatrixXd d = response.bottomRightCorner(response.rows() - n, one.inputs()) -
                     c * response.topRightCorner(n, one.inputs());
  const LinearSide found{rates.leftCols(n), rates.rightCols(one.inputs()), c, d};
  return check_rates(name, one, found, length), found;
}

}  // namespace tandem::stability
