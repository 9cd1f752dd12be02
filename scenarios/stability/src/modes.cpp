// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/stability/modes.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "tandem/error.hpp"
#include "tandem/scenario/by_signals.hpp"
#include "true_modes.hpp"

namespace tandem::stability {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::VectorXcd;

/// Eigenvalues, or rates, with eigenvectors, of which the part of the states counts.
struct Pairs {
  VectorXcd values;
  Eigen::MatrixXcd vectors;
};

Pairs pairs_of(const Eigen::MatrixXd& map, const std::vector<Index>& rows) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(map);
  Pairs pairs{solver.eigenvalues(), Eigen::MatrixXcd(static_cast<Index>(rows.size()), map.cols())};
  const Eigen::MatrixXcd all = solver.eigenvectors();
  for (Index k = 0; k < pairs.vectors.rows(); ++k)
    pairs.vectors.row(k) = all.row(rows[static_cast<std::size_t>(k)]);
  return pairs;
}

/// States by which modes are told: their numbers in the system undivided, and in the map.
struct Told {
  std::vector<Index> whole, map;
};

/// slow: also of the slow sides of impulse couplings, which stand at their nodes without the fast motion. Surrogates are no part
/// of the system undivided.
Told told_by(const SuperStep& step, const scenario::Scenario& scenario, bool slow) {
  const auto is_slow = [&](int i) {
    return std::any_of(scenario.subsystems.begin(), scenario.subsystems.end(), [&](const auto& one) {
      return one.impulse && one.impulse->slow == scenario.subsystems[static_cast<std::size_t>(i)].name;
    });
  };
  Told told;
  Index state = 0;
  for (std::size_t k = 0; k < step.coordinates.size(); ++k) {
    const Coordinate& c = step.coordinates[k];
    if (c.age >= 0 || is_of_surrogate(c, scenario)) continue;
    if (slow || !is_slow(c.subsystem)) told.whole.push_back(state), told.map.push_back(static_cast<Index>(k));
    ++state;
  }
  return told;
}

/// |a* b|^2 / (a* a)(b* b), of vectors that are scaled alike.
double likeness(const VectorXcd& a, const VectorXcd& b) {
  const double both = a.squaredNorm() * b.squaredNorm();
  return both > 0.0 ? std::norm(a.dot(b)) / both : 0.0;
}

/// Modes of the system undivided and of the scheme, by states that are scaled alike.
struct Both {
  Both(const TrueModes& whole, const SuperStep& step, const Told& told)
      : exact{whole.rates, whole.vectors(told.whole, Eigen::all)}, here(pairs_of(step.map, told.map)) {
    const Eigen::VectorXd largest = exact.vectors.cwiseAbs().rowwise().maxCoeff();
    for (Pairs* pairs : {&exact, &here})
      for (Index k = 0; k < largest.size(); ++k)
        if (largest[k] > 0.0) pairs->vectors.row(k) /= largest[k];
  }
  double alike(Index k, Index j) const { return likeness(here.vectors.col(j), exact.vectors.col(k)); }
  Pairs exact, here;
};

class Matching {
 public:
  Matching(const TrueModes& whole, const SuperStep& step, const scenario::Scenario& scenario)
      : period_(step.period),
        taken_(static_cast<std::size_t>(step.map.cols())),
        by_nearness_(step.offsets > 0),
        all_(whole, step, told_by(step, scenario, true)) {
    if (step.offsets > 0) fast_.emplace(whole, step, told_by(step, scenario, false));
    parts_ = whole.parts;
  }

  /// One of each pair of conjugates, the fastest first.
  std::vector<Mode> modes() {
    std::vector<Mode> all;
    leave_at_rest();
    for (Index k = 0; k < all_.exact.values.size(); ++k)
      if (all_.exact.values[k].imag() >= 0.0 && !is_at_rest(k)) all.push_back(mode(k));
    std::stable_sort(all.begin(), all.end(),
                     [](const Mode& a, const Mode& b) { return a.frequency > b.frequency; });
    return all;
  }

 private:
  bool is_at_rest(Index k) const { return std::abs(all_.exact.values[k]) * period_ <= TrueModes::rest; }

  /// Of the scheme's the nearest to 1 stand for those.
  void leave_at_rest() {
    for (Index k = 0; k < all_.exact.values.size(); ++k) {
      if (!is_at_rest(k)) continue;
      const auto far = [&](std::size_t j) { return std::abs(all_.here.values[static_cast<Index>(j)] - 1.0); };
      std::size_t nearest = taken_.size();
      for (std::size_t j = 0; j < taken_.size(); ++j)
        if (!taken_[j] && (nearest == taken_.size() || far(j) < far(nearest))) nearest = j;
      if (nearest < taken_.size()) taken_[nearest] = 1;
    }
  }

  /// For a mode that swings with its conjugate.
  void take(Index which, bool swings) {
    const Complex lambda = all_.here.values[which];
    for (Index j = 0; j < all_.here.values.size(); ++j)
      if (j == which || (swings && lambda.imag() != 0.0 && all_.here.values[j] == std::conj(lambda)))
        taken_[static_cast<std::size_t>(j)] = 1;
  }

  double alike(Index k, Index j) const {
    const double all = all_.alike(k, j);
    return fast_ ? std::max(all, fast_->alike(k, j)) : all;
  }

  /// The scheme's pair that is most like a true one, and near it: likeness alone does not tell conjugates. An impulse coupling
  /// errs by little, and offsets are like any slow mode.
  Index best_for(Index k) {
    const double of_likeness = by_nearness_ ? 0.05 : 1.0, of_nearness = by_nearness_ ? 1.0 : 0.25;
    Index best = 0;
    double most = -1.0;
    const Complex expected = std::exp(all_.exact.values[k] * period_);
    for (Index j = 0; j < all_.here.values.size(); ++j) {
      const Complex lambda = all_.here.values[j];
      const double far = std::abs(lambda - expected) / (1.0 + std::abs(lambda));
      const double score = of_likeness * alike(k, j) - of_nearness * far;
      if (!taken_[static_cast<std::size_t>(j)] && score > most) most = score, best = j;
    }
    take(best, all_.exact.values[k].imag() != 0.0);
    return best;
  }

  Mode mode(Index k) {
    const Index j = best_for(k);
    const Complex mu = all_.exact.values[k], lambda = all_.here.values[j];
    constexpr double turn = 2.0 * std::numbers::pi;
    const double size = std::abs(mu), growth = std::abs(lambda);
    const double late = std::arg(lambda * std::exp(Complex(0.0, -mu.imag() * period_)));
    return {.rate = mu.real(),
            .frequency = mu.imag() / turn,
            .damping = size > 0.0 ? -mu.real() / size : 0.0,
            .scheme_frequency = (mu.imag() + late / period_) / turn,
            .scheme_damping = size > 0.0 ? -std::log(growth) / (period_ * size) : 0.0,
            .growth = growth,
            .parts = parts_.col(k),
            .likeness = alike(k, j)};
  }

  double period_;
  std::vector<char> taken_;
  bool by_nearness_;
  Both all_;
  std::optional<Both> fast_;  ///< by the fast sides' states alone
  Eigen::MatrixXd parts_;     ///< of states in true modes
};

}  // namespace

std::string Stability::mostly(const Mode& mode) const {
  constexpr double third = 1.0 / 3.0;
  std::string text;
  for (Index k = 0; k < mode.parts.size(); ++k)
    if (mode.parts[k] >= third * mode.parts.maxCoeff())
      text += (text.empty() ? "" : ", ") + states[static_cast<std::size_t>(k)];
  return text;
}

bool is_stable(const SuperStep& step, double radius, double rate) {
  constexpr double like = 1.01;  // of a rate that grows: the integrators' own error
  return std::log(radius) <= like * rate * step.period + step.rounding();
}

bool Stability::is_unstable() const { return !is_stable(step, radius, rate); }

Stability stability(const scenario::Scenario& scenario, const Builtins& builtins) {
  Stability all;
  all.step = super_step(scenario, builtins);
  if (all.step.map.size() == 0)
    throw Error(ErrorCode::not_supported,
                scenario.file.string() +
                    ": no subsystem gives its states, or has inputs by which they could be found; "
                    "allowed are those that do");
  all.radius = all.step.radius();
  try {
    const scenario::Scenario apart = scenario::by_signals(scenario);
    const Trial trial(apart, builtins);
    const TrueModes whole = true_modes(trial, all.step.linear);
    all.states = whole.states;
    all.step.at_rest = whole.at_rest;
    all.radius = all.step.radius();
    all.modes = Matching(whole, all.step, scenario).modes();
    constexpr double rounding = 1e-8;  // of a damping ratio
    for (const Mode& mode : all.modes)
      if (mode.damping < -rounding) all.rate = std::max(all.rate, mode.rate);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::not_supported && !scenario::by_impulse(scenario)) throw;
    all.unknown = error.what();
  }
  return all;
}

}  // namespace tandem::stability
