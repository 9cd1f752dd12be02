// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/stability/super_step.hpp"

#include <Eigen/Eigenvalues>
#include <random>

#include "trial.hpp"

namespace tandem::stability {
namespace {

using Eigen::VectorXd;

/// Whether half of a change makes half of the effect.
bool is_linear(Trial& trial) {
  constexpr double tolerance = 1e-10;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const VectorXd change = VectorXd::NullaryExpr(trial.start().size(), [&] { return any(random); });
  const VectorXd from = trial.after(trial.start());
  const VectorXd whole = trial.after(trial.start() + change) - from,
                 half = trial.after(trial.start() + 0.5 * change) - from;
  return (whole - 2.0 * half).norm() <= tolerance * (whole.norm() + from.norm());
}

/// Of a map that is linear beside what does not depend on z.
Eigen::MatrixXd columns(Trial& trial) {
  const Eigen::Index size = trial.start().size();
  const VectorXd from = trial.after(VectorXd::Zero(size));
  Eigen::MatrixXd map(size, size);
  for (Eigen::Index k = 0; k < size; ++k) map.col(k) = trial.after(VectorXd::Unit(size, k)) - from;
  return map;
}

/// Central differences; the change is the cube root of rounding times the number's size, where both errors meet.
Eigen::MatrixXd differences(Trial& trial) {
  constexpr double part = 6e-6, least = 1e-3;
  const VectorXd& z = trial.start();
  Eigen::MatrixXd map(z.size(), z.size());
  for (Eigen::Index k = 0; k < z.size(); ++k) {
    const VectorXd change = part * std::max(std::abs(z[k]), least) * VectorXd::Unit(z.size(), k);
    map.col(k) = (trial.after(z + change) - trial.after(z - change)) / (2.0 * change[k]);
  }
  return map;
}

}  // namespace

SuperStep super_step(const scenario::Scenario& scenario, const Builtins& builtins) {
  Trial trial(scenario, builtins);
  SuperStep step{trial.period().length, trial.period().steps, trial.coordinates(), {}, is_linear(trial)};
  step.map = step.linear ? columns(trial) : differences(trial);
  return step;
}

double spectral_radius(const Eigen::MatrixXd& map) {
  return Eigen::EigenSolver<Eigen::MatrixXd>(map, false).eigenvalues().cwiseAbs().maxCoeff();
}

}  // namespace tandem::stability
