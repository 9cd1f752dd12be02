// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/equilibrium.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "../dense.hpp"
#include "linear_forces.hpp"
#include "scaled.hpp"
#include "tandem/error.hpp"

namespace tandem::mbs {
namespace {

constexpr int most_iterations = 100, most_corrections = 4, most_relaxations = 1000;
constexpr double balanced = 1e-10, nearly_balanced = 1e-7;  // of the largest force
constexpr double closed = 1e-12, loosely_closed = 1e-9;     // of a length
constexpr double longest = 1.0;                             // step, of a length
constexpr double held = 1e-8;  // of the largest stiffness: what holds where nothing else does

/// Newton's method on Q(q, 0) - Phi_q^T lambda = 0, Phi = 0. Multipliers are those of least squares, so that
/// the error is a function of q alone.
class Balance {
 public:
  Balance(Model& model, State start, const Known& known)
      : terms_(model),
        names_(model.structure().variable_names),
        unit_(model.structure().unit()),
        state_(std::move(start)) {
    stays_.setConstant(terms_.force.size(), false);
    for (const auto& k : known.positions)
      if (k.coordinate < stays_.size()) stays_[k.coordinate] = true;
    state_.v.setZero();
    look(state_);
  }

  State find() {
    if (newton() || relax()) return state_;
    Eigen::Index worst = 0;
    unbalanced_.cwiseAbs().maxCoeff(&worst);
    throw Error(
        ErrorCode::numerical,
        fmt::format("no equilibrium is found: {} is left with a force of {:.3g}; allowed is a mechanism "
                    "whose forces balance where nothing moves",
                    names_[static_cast<std::size_t>(worst)], unbalanced_[worst]));
  }

 private:
  struct Linear {
    Eigen::MatrixXd k, gradients;
    Eigen::VectorXd force, phi;
    double least;  ///< hold
  };

  bool balances() const { return error_ <= balanced * size_; }
  bool balances_nearly() const { return error_ <= nearly_balanced * size_; }

  bool newton() {
    for (int k = 0; k < most_iterations && !balances(); ++k) {
      const double before = error_;
      if (!improve()) break;
      if (error_ > 0.5 * before && balances_nearly()) break;
    }
    return balances_nearly();
  }

  /// Where no step makes the error smaller, forces still show a way: steps of a motion in which each force is
  /// a speed, long where they are steady (pseudo-transient continuation, C. T. Kelley, D. E. Keyes, SIAM J.
  /// Numer. Anal. 35 (1998) 508). One is taken if the forces do work along it, which a potential falls by.
  bool relax() {
    const double first = error_ / unit_;
    double hold = first;
    for (int k = 0; k < most_relaxations && !balances() && std::isfinite(hold); ++k)
      hold = follow(hold) ? std::max(0.2 * hold, held * first) : 10.0 * hold;
    return balances_nearly();
  }

  bool follow(double hold) {
    const Linear at = linearize();
    const State from = state_;
    const Eigen::VectorXd by = step(at, std::max(hold, at.least));
    if (by.norm() <= longest * unit_) {
      const Eigen::VectorXd before = unbalanced_;
      go(from, by);
      const auto moved = state_.q.head(by.size()) - from.q.head(by.size());
      if (terms_.phi.norm() <= loosely_closed * unit_ && (before + unbalanced_).dot(moved) > 0.0) return true;
    }
    state_ = from;
    look(state_);
    return false;
  }

  /// The error and multipliers at a state.
  void look(State& s) {
    terms_.evaluate(s.q, s.v);
    const Eigen::MatrixXd a = movable();
    Eigen::VectorXd f = terms_.force;
    for (int i = 0; i < stays_.size(); ++i)
      if (stays_[i]) f[i] = 0.0;
    if (s.lambda.size() > 0) s.lambda = dense::shortest_solution(a, f);
    unbalanced_ = f - a * s.lambda;
    size_ = std::max(size_, terms_.force.norm());
    error_ = std::hypot(unbalanced_.norm(), size_ * terms_.phi.norm() / unit_);
  }

  /// The gradients' part along what may move.
  Eigen::MatrixXd movable() const {
    Eigen::MatrixXd a = terms_.gradients;
    for (int i = 0; i < stays_.size(); ++i)
      if (stays_[i]) a.row(i).setZero();
    return a;
  }

  /// Back to where the constraints hold, by the shortest way: along a step they bend away, and an error that
  /// counts this too would fall by the shortest of steps only.
  void close(State& s) {
    for (int k = 0; k < most_corrections && terms_.phi.norm() > closed * unit_; ++k) {
      s.q.head(stays_.size()) -= dense::shortest_solution(movable().transpose(), terms_.phi);
      terms_.evaluate(s.q, s.v);
    }
  }

  Linear linearize() {
    Eigen::MatrixXd k = terms_.stiffness(state_);
    look(state_);
    const double least = held * k.cwiseAbs().maxCoeff();
    return {std::move(k), terms_.gradients, unbalanced_, terms_.phi, least};
  }

  void go(const State& from, const Eigen::VectorXd& by) {
    state_.q.head(by.size()) = from.q.head(by.size()) + by;
    terms_.evaluate(state_.q, state_.v);
    close(state_);
    look(state_);
  }

  /// A step that makes the error smaller: Newton's, or one that is held back more and more, as far as it is
  /// not too long (what nothing holds would turn over and over), or else a part of Newton's; false if none
  /// does.
  bool improve() {
    const Linear at = linearize();
    const double before = error_;
    const State from = state_;
    const auto improves = [&](const Eigen::VectorXd& by) {
      go(from, by);
      return error_ < before;
    };
    const auto more = [](double hold) { return hold > 0.0 ? 10.0 * hold : 1e-6; };
    double hold = at.least;
    while (hold < 1e12) {
      const Eigen::VectorXd by = step(at, hold);
      if (by.norm() <= longest * unit_ && improves(by)) return true;
      hold = more(hold);
    }
    const Eigen::VectorXd newton = step(at, at.least);
    for (int halvings = 1; halvings < 10; ++halvings)
      if (improves(std::ldexp(1.0, -halvings) * newton)) return true;
    state_ = from;
    look(state_);
    return false;
  }

  Eigen::VectorXd step(const Linear& at, double hold) const {
    const auto n = at.force.size(), m = at.phi.size();
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n + m, n + m);
    Eigen::VectorXd b(n + m);
    a.topLeftCorner(n, n) = at.k;
    a.topLeftCorner(n, n).diagonal().array() += hold;
    a.topRightCorner(n, m) = at.gradients;
    a.bottomLeftCorner(m, n) = at.gradients.transpose();
    a.bottomRightCorner(m, m).diagonal().setConstant(-1e-12);  // redundant equations
    b << at.force, -at.phi;
    for (int i = 0; i < n; ++i)
      if (stays_[i]) a.row(i).setZero(), a(i, i) = 1.0, b[i] = 0.0;
    return dense::solve_by_lu(a, b).head(n);
  }

  DenseTerms terms_;
  const std::vector<std::string>& names_;
  double unit_;
  State state_;
  Eigen::Array<bool, Eigen::Dynamic, 1> stays_;
  Eigen::VectorXd unbalanced_;
  double error_ = 0.0, size_ = 1e-300;  // the largest force so far
};

}  // namespace

State equilibrium(Model& of, State start, const Known& known) {
  Scaled model(of);
  model.scale(start);
  State s = Balance(model, std::move(start), known).find();
  model.restore(s);
  return s;
}

}  // namespace tandem::mbs
