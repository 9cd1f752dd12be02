// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "undivided.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "linear_side.hpp"
#include "tandem/error.hpp"

namespace tandem::stability {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

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

LinearSide nothing(const SubsystemInfo& of) {
  const int inputs = of.input_size(), outputs = of.output_size();
  return {MatrixXd(0, 0), MatrixXd(0, inputs), MatrixXd(outputs, 0), MatrixXd::Zero(outputs, inputs)};
}

/// States, then outputs in effect, then as many as wait at one time.
LinearSide held(const Trial& trial, int instance) {
  constexpr double rounding = 1e-9;
  const SubsystemInfo& info = trial.topology().info(instance);
  const Index states = trial.model(instance).order(), width = info.output_size();
  const auto waiting =
      static_cast<Index>(std::ceil(info.sampling.latency / trial.own_step(instance) - rounding));
  const Index size = states + (1 + std::max(Index{0}, waiting)) * width;
  LinearSide one{MatrixXd::Zero(size, size), MatrixXd::Zero(size, info.input_size()),
                 MatrixXd::Zero(width, size), MatrixXd::Zero(width, info.input_size())};
  one.c.middleCols(states, width).setIdentity();
  return one;
}

LinearSide side_of(const Trial& trial, int instance, bool is_linear, Sampled sampled) {
  const SubsystemInfo& info = trial.topology().info(instance);
  if (!info.abilities.sampled) return linear_side(trial, instance, is_linear);
  return sampled == Sampled::held ? held(trial, instance) : nothing(info);
}

}  // namespace

Undivided undivided(const Trial& trial, bool is_linear, Sampled sampled) {
  Undivided all;
  LinearSide sum;
  for (int i = 0; i < trial.topology().size(); ++i) {
    const LinearSide one = side_of(trial, i, is_linear, sampled);
    const std::size_t states = one.g.rows() > 0 ? trial.states(i).size() : 0;
    all.state_at.push_back(sum.g.rows()), all.output_at.push_back(sum.c.rows());
    all.held_at.push_back(sum.g.rows() + static_cast<Index>(states));
    append(sum.g, one.g), append(sum.b, one.b), append(sum.c, one.c), append(sum.d, one.d);
    for (std::size_t k = 0; k < states; ++k)
      all.names.push_back(trial.topology().name(i) + '.' + trial.states(i)[k].name);
    all.names.resize(static_cast<std::size_t>(sum.g.rows()));
  }
  const MatrixXd l = connections(trial.topology());
  const Eigen::FullPivLU<MatrixXd> loop(MatrixXd::Identity(l.rows(), l.rows()) - l * sum.d);
  if (!loop.isInvertible())
    throw Error(ErrorCode::not_supported, "the connections make a loop at once that has no solution");
  const MatrixXd inputs = loop.solve(l * sum.c);
  all.rates = sum.g + sum.b * inputs;
  all.outputs = sum.c + sum.d * inputs;
  return all;
}

Participation participation(const Undivided& whole) {
  if (whole.rates.size() == 0) return {};
  const Eigen::EigenSolver<MatrixXd> solver(whole.rates);
  const Eigen::MatrixXcd modes = solver.eigenvectors();
  return {solver.eigenvalues(), modes,
          modes.cwiseProduct(modes.fullPivLu().inverse().transpose()).cwiseAbs()};
}

}  // namespace tandem::stability
