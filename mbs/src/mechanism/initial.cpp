// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/mechanism/initial.hpp"

#include <fmt/format.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "refuse.hpp"

namespace tandem::mbs {
namespace {

using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

constexpr int most_iterations = 100;
constexpr double rounding = 1e-12, settled = 1e-9;  ///< of 1 + the largest coordinate

/// Phi and Phi_q where a model stands.
class Linearized {
 public:
  Linearized(Model& model, const std::vector<std::pair<int, double>>& known)
      : phi(model.structure().constraints),
        model_(model),
        values_(static_cast<std::size_t>(model.structure().jacobian_values())),
        known_(known) {}

  void evaluate(const VectorXd& q) { model_.constraints(q.data(), phi.data(), values_.data()); }

  /// Phi_q v.
  VectorXd rate(const VectorXd& v) const { return transposed().transpose() * v.head(variables()); }

  /// The shortest step of the unknown coordinates with Phi_q d = -error, as nearly as there is one:
  /// (1 + alpha Phi_q^T Phi_q) d = -alpha Phi_q^T error.
  VectorXd step(const VectorXd& error) const {
    Sparse a = transposed();
    std::vector<bool> keeps(static_cast<std::size_t>(a.rows()));
    for (const auto& [i, value] : known_)
      if (i < a.rows()) keeps[i] = true;
    a.prune([&](Eigen::Index row, Eigen::Index, double) { return !keeps[row]; });
    const double alpha =
        1e10 /
        std::max(1e-300, a.cwiseProduct(a).sum() / static_cast<double>(std::max<Eigen::Index>(1, a.cols())));
    Sparse matrix = alpha * (a * Sparse(a.transpose()));
    Sparse one(a.rows(), a.rows());
    one.setIdentity();
    matrix += one;
    const Eigen::SimplicialLDLT<Sparse> solver(matrix);
    return -alpha * solver.solve(a * error);
  }

  int variables() const { return model_.structure().variables; }

  VectorXd phi;

 private:
  Eigen::Map<const Sparse> transposed() const {
    const Pattern& p = model_.structure().jacobian;
    return {p.rows(), p.columns(), p.size(), p.starts().data(), p.indices().data(), values_.data()};
  }

  Model& model_;
  std::vector<double> values_;
  const std::vector<std::pair<int, double>>& known_;
};

double largest(const VectorXd& x) { return x.size() > 0 ? x.lpNorm<Eigen::Infinity>() : 0.0; }

[[noreturn]] void impossible(const Model& model, const std::string& what, const VectorXd& error) {
  Eigen::Index worst = 0;
  const double off = error.cwiseAbs().maxCoeff(&worst);
  throw Error(ErrorCode::invalid_argument,
              fmt::format("{}: constraint '{}' is off by {}", what,
                          model.structure().constraint_names[static_cast<std::size_t>(worst)], off));
}

/// Half of a step at a time while it makes things worse.
void take(Linearized& at, VectorXd& q, const VectorXd& step) {
  const VectorXd before = q;
  const double error = at.phi.norm();
  for (double part = 1.0; part > 1e-4; part *= 0.5) {
    q.head(step.size()) = before.head(step.size()) + part * step;
    at.evaluate(q);
    if (at.phi.norm() < error) return;
  }
}

/// Newton's method from where s stands.
void close(Model& model, State& s, const Known& known) {
  Linearized at(model, known.positions);
  at.evaluate(s.q);
  double before = largest(at.phi);
  if (before <= rounding * (1.0 + largest(s.q))) return;
  for (int k = 0; k < most_iterations; ++k) {
    take(at, s.q, at.step(at.phi));
    const double now = largest(at.phi);
    if (!(now < 0.5 * before) && now <= settled * (1.0 + largest(s.q))) return;
    before = now;
  }
  impossible(model, "the mechanism can't be assembled with the given positions", at.phi);
}

/// Known positions are approached by parts of at most a quarter of a unit: an angle's equation has a second
/// solution half a turn away.
void assemble(Model& model, State& s, const Known& known) {
  const VectorXd from = s.q;
  double way = 0.0;
  for (const auto& [i, value] : known.positions) way = std::max(way, std::abs(value - from[i]));
  const int parts = static_cast<int>(std::clamp(std::ceil(4.0 * way), 1.0, 200.0));
  for (int part = 1; part <= parts; ++part) {
    for (const auto& [i, value] : known.positions)
      s.q[i] = part == parts ? value : from[i] + (value - from[i]) * part / parts;
    close(model, s, known);
  }
}

void find_velocities(Model& model, State& s, const Known& known) {
  for (const auto& [i, value] : known.velocities) s.v[i] = value;
  Linearized at(model, known.velocities);
  at.evaluate(s.q);
  VectorXd motion(at.phi.size()), error;
  model.constraint_rates(s.q.data(), motion.data());
  for (int k = 0; k < 4; ++k) {
    error = at.rate(s.v) + motion;
    if (largest(error) <= rounding * (1.0 + largest(s.v))) return;
    s.v.head(at.variables()) += at.step(error);
  }
  error = at.rate(s.v) + motion;
  if (largest(error) > settled * (1.0 + largest(s.v)))
    impossible(model, "no velocities fit the constraints and the given velocities", error);
}

/// That none is half a turn away from what its edges show.
void check_angles(const Mechanism& mechanism, const State& s) {
  Description stands = mechanism.description();
  for (std::size_t e = 0; e < stands.entities.size(); ++e)
    stands.entities[e].at.head(stands.dimension) =
        s.q.segment(mechanism.coordinate(static_cast<int>(e)), stands.dimension);
  for (std::size_t r = 0; r < stands.relatives.size(); ++r)
    if (const double shown = drawn(stands, stands.relatives[r]),
        angle = s.q[mechanism.numbering().relative[r]];
        stands.relatives[r].kind == Relative::Kind::angle && std::cos(shown - angle) < 0.0)
      refuse(stands.relatives[r].where,
             fmt::format(
                 "angle '{}' is {} rad where the mechanism was assembled, but its edges stand at {}; draw "
                 "them nearer to it",
                 stands.relatives[r].name, angle, shown));
}

}  // namespace

State consistent_state(Model& model, State s, const Known& known) {
  model.at_time(s.time);
  assemble(model, s, known);
  find_velocities(model, s, known);
  return s;
}

State initial_state(Mechanism& mechanism, double t) {
  const Description& in = mechanism.description();
  Known known;
  for (const Given& g : in.positions)
    known.positions.emplace_back(mechanism.numbering().of(g.coordinate), g.value);
  for (const Given& g : in.velocities)
    known.velocities.emplace_back(mechanism.numbering().of(g.coordinate), g.value);
  State s = mechanism.described_state();
  s.time = t;
  s = consistent_state(mechanism, std::move(s), known);
  check_angles(mechanism, s);
  return s;
}

}  // namespace tandem::mbs
