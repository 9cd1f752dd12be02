// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "undivided.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

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

}  // namespace

Undivided undivided(const Trial& trial, bool is_linear, Sampled sampled) {
  Undivided all;
  LinearSide sum;
  for (int i = 0; i < trial.topology().size(); ++i) {
    const SubsystemInfo& info = trial.topology().info(i);
    if (info.abilities.sampled && sampled == Sampled::refused)
      throw Error(ErrorCode::not_supported,
                  "subsystem '" + trial.topology().name(i) +
                      "' is sampled, and the system undivided is known without such");
    const LinearSide one = info.abilities.sampled ? nothing(info) : linear_side(trial, i, is_linear);
    append(sum.g, one.g), append(sum.b, one.b), append(sum.c, one.c), append(sum.d, one.d);
    if (info.abilities.sampled) continue;
    for (const StateName& state : trial.states(i))
      all.names.push_back(trial.topology().name(i) + '.' + state.name);
  }
  const MatrixXd l = connections(trial.topology());
  const Eigen::FullPivLU<MatrixXd> loop(MatrixXd::Identity(l.rows(), l.rows()) - l * sum.d);
  if (!loop.isInvertible())
    throw Error(ErrorCode::not_supported, "the connections make a loop at once that has no solution");
  all.rates = sum.g + sum.b * loop.solve(l * sum.c);
  return all;
}

Participation participation(const Undivided& whole) {
  if (whole.rates.size() == 0) return {};
  const Eigen::EigenSolver<MatrixXd> solver(whole.rates);
  const Eigen::MatrixXcd modes = solver.eigenvectors();
  return {solver.eigenvalues(), modes.cwiseProduct(modes.fullPivLu().inverse().transpose()).cwiseAbs()};
}

}  // namespace tandem::stability
