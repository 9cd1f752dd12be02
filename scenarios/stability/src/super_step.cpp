// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/stability/super_step.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <numeric>
#include <random>

#include "difference.hpp"
#include "trial.hpp"

namespace tandem::stability {
namespace {

using Eigen::VectorXd;

/// Whether half of a change makes half of the effect. One that can't be taken at all (rods that do not reach) makes
/// none.
bool is_linear(Trial& trial) try {
  constexpr double tolerance = 1e-10;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const VectorXd change = VectorXd::NullaryExpr(trial.start().size(), [&] { return any(random); });
  const VectorXd from = trial.after(trial.start());
  const VectorXd whole = trial.after(trial.start() + change) - from,
                 half = trial.after(trial.start() + 0.5 * change) - from;
  return (whole - 2.0 * half).norm() <= tolerance * (whole.norm() + from.norm());
} catch (const Error&) {
  return false;
}

/// Of a map that is linear beside what does not depend on z.
Eigen::MatrixXd columns(Trial& trial) {
  const VectorXd& z = trial.start();
  const VectorXd from = trial.after(z);
  Eigen::MatrixXd map(z.size(), z.size());
  for (Eigen::Index k = 0; k < z.size(); ++k)
    map.col(k) = trial.after(z + VectorXd::Unit(z.size(), k)) - from;
  return map;
}

/// By a part of each number's size.
Eigen::MatrixXd differences(Trial& trial, double part) {
  constexpr double least = 1e-3;
  const VectorXd& z = trial.start();
  Eigen::MatrixXd map(z.size(), z.size());
  for (Eigen::Index k = 0; k < z.size(); ++k)
    map.col(k) = difference([&](const VectorXd& at) { return trial.after(at); }, z, k,
                            part * std::max(std::abs(z[k]), least));
  return map;
}

/// Numbers of surrogates that stay what they are, as their coupling has no use for them.
int kept_numbers(const SuperStep& step, const scenario::Scenario& scenario) {
  constexpr double rounding = 1e-9;
  int count = 0;
  for (std::size_t k = 0; k < step.coordinates.size(); ++k) {
    if (!is_of_surrogate(step.coordinates[k], scenario)) continue;
    const auto row = static_cast<Eigen::Index>(k);
    const Eigen::RowVectorXd unit = Eigen::RowVectorXd::Unit(step.map.cols(), row);
    if ((step.map.row(row) - unit).cwiseAbs().maxCoeff() <= rounding) ++count;
  }
  return count;
}

/// The smaller change is the cube root of rounding, where both errors of a difference meet. By a larger one it is seen what
/// subsystems leave of their iterations.
void differentiate(Trial& trial, const std::string& file, SuperStep& to) {
  constexpr double small = 6e-6, large = 6e-5, most = 1e-3;
  SuperStep other = to;
  to.map = differences(trial, small), other.map = differences(trial, large);
  to.unsettled = std::abs(to.radius() - other.radius());
  if (!(to.unsettled <= most))
    throw Error(
        ErrorCode::not_supported,
        fmt::format(
            "{}: the map of a super-step does not settle: by differences of two sizes its spectral radius "
            "differs by {:.2g}; allowed is {}. A subsystem gives values that are known less well than its "
            "states, such as the reaction of a prescribed motion",
            file, to.unsettled, most));
}

}  // namespace

/// Of one that is a subsystem, or a part of its fast side.
bool is_of_surrogate(const Coordinate& c, const scenario::Scenario& scenario) {
  return std::any_of(scenario.subsystems.begin(), scenario.subsystems.end(), [&](const auto& entry) {
    if (!entry.impulse) return false;
    const std::string own = entry.name + ".";
    return c.name.starts_with(own) || c.name.starts_with(entry.impulse->links[0].fast + "." + own);
  });
}

SuperStep super_step(const scenario::Scenario& scenario, const Builtins& builtins) {
  Trial trial(scenario, builtins);
  SuperStep step;
  step.period = trial.period().length, step.steps = trial.period().steps, step.apart = trial.period().apart;
  for (int i = 0; i < trial.topology().size(); ++i) {
    step.own_steps.push_back(trial.own_step(i));
    step.sampled.push_back(trial.topology().info(i).abilities.sampled);
  }
  step.coordinates = trial.coordinates(), step.identified = trial.identified();
  for (const auto& one : scenario.subsystems)
    if (one.impulse) step.offsets += 2 * static_cast<int>(one.impulse->links.size());
  step.linear = is_linear(trial);
  if (step.linear)
    step.map = columns(trial);
  else
    differentiate(trial, scenario.file.string(), step);
  step.offsets += kept_numbers(step, scenario);
  for (const Identified& one : step.identified) step.linear = step.linear && one.linear;
  return step;
}

double SuperStep::rounding() const {
  constexpr double of_differences = 1e-5;  // two eigenvalues that meet at 1, and 1e-11 in the map: 3e-6
  constexpr double of_offsets = 1e-7;      // likewise, and 1e-14
  double most = linear ? (offsets > 0 ? of_offsets : 1e-9) : std::max(of_differences, unsettled);
  for (const Identified& one : identified) most = std::max(most, 10.0 * one.residual);
  return most;
}

double SuperStep::radius() const {
  if (map.size() == 0) return 0.0;
  const Eigen::VectorXcd values = Eigen::EigenSolver<Eigen::MatrixXd>(map, false).eigenvalues();
  std::vector<std::complex<double>> all(values.begin(), values.end());
  std::sort(all.begin(), all.end(),
            [](const auto& a, const auto& b) { return std::abs(a - 1.0) < std::abs(b - 1.0); });
  double largest = offsets > 0 ? 1.0 : 0.0;
  const auto gone = all.begin() + offsets, rest = gone + std::min<std::ptrdiff_t>(at_rest, all.end() - gone);
  if (rest != gone)
    largest = std::max(largest,
                       std::abs(std::accumulate(gone, rest, std::complex<double>()) / double(rest - gone)));
  for (auto it = rest; it != all.end(); ++it) largest = std::max(largest, std::abs(*it));
  return largest;
}

}  // namespace tandem::stability
