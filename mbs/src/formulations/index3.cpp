// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/formulations/index3.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "check_memory.hpp"
#include "checks.hpp"
#include "flush_denormals.hpp"
#include "merged_frequency.hpp"
#include "settings.hpp"
#include "tandem/mbs/integrators/frequency.hpp"
#include "team.hpp"
#include "timed.hpp"

namespace tandem::mbs {
namespace {

constexpr double gamma = 0.5;           // any other value of Newmark's gamma leaves order 1
constexpr double settled = 1e-12;       // accelerations at the start: some thousand roundings
constexpr double shortest = 1e-3;       // [s] step with the penalty as it is
constexpr double short_part = 0.02;     // of an own step
constexpr int most_substitutions = 10;  // about what a new factor costs

const Index3Settings& checked(const Index3Settings& s) {
  const auto setting = [](const char* name, double value) {
    return Setting{"index-3 formulation", name, value};
  };
  setting("penalty", s.penalty).at_least(0.0, "a number above 0");
  check_beta("index-3 formulation", s.beta);
  setting("tolerance", s.tolerance).at_least(0.0, "a number above 0");
  setting("most_iterations", s.most_iterations).count();
  setting("projections", s.projections).count();
  setting("multiplier_iterations", s.multiplier_iterations).count();
  setting("threads", s.threads).count();
  setting("threads_from", s.threads_from).count();
  if (s.threads > 1 && !threads_are_built_in())
    throw Error(ErrorCode::not_supported,
                fmt::format("index-3 formulation: threads is {}; allowed is 1, as this tandem was built "
                            "without OpenMP",
                            s.threads));
  return s;
}

MatrixKind kind_of_tangent(const Structure& s) {
  return s.symmetric_forces ? MatrixKind::positive_definite : MatrixKind::unsymmetric;
}

/// After one substitution, by more of them with the factor at hand; false as soon as they, each leaving the
/// part that the last one left, would be too many.
bool goes_on_to_settle(Terms& terms, State& s, double weight) {
  double before = terms.correction.norm();
  for (int left = most_substitutions - 2; left >= 0; --left) {
    if (terms.settle(s, weight, settled, 1) > 0) return true;
    const double change = terms.correction.norm();
    const double allowed = settled * (s.a.norm() + terms.force.norm() / terms.largest_mass);
    if (!(change * std::pow(change / before, left) <= allowed)) return false;
    before = change;
  }
  return false;
}

}  // namespace

bool threads_are_built_in() { return Team::can_be_many; }

Index3::Index3(Model& model, const Index3Settings& settings)
    : settings_(checked(settings)),
      terms_(model, settings.solver, kind_of_tangent(model.structure())),
      tolerance_(terms_.structure.tolerance(settings.tolerance, 1e-10)),
      penalty_(penalty(std::max(shortest, settings_.own_step))),
      left_(Eigen::VectorXd::Zero(terms_.structure.constraints)) {
  if (settings_.beta < 0.25) highest_ = std::make_unique<MergedFrequency>(terms_);
}

Index3::~Index3() = default;

/// What holds a constraint in a step is alpha h^2 beside the mass: by default it does not fall below that of
/// a step of 1 ms. A step that is cut has (own step / h) times alpha: with alpha as it is constraints are
/// lost bit by bit, and with the square of that what rounding leaves in them becomes a force, in flat
/// positions above all. (Both were measured on the linkage with the engine.)
double Index3::penalty(double h) const {
  const double whole = std::max(h, settings_.own_step), cut = whole / h;
  const double more = whole < shortest ? (shortest / whole) * (shortest / whole) : 1.0;
  if (settings_.penalty > 0.0) return settings_.penalty * cut;
  return 1e7 * terms_.largest_mass * more * cut;
}

void Index3::start(State& s) {
  const FlushDenormals scope;
  steps_ = 0;
  needs_own_ = false;
  left_.setZero();
  terms_.model.at_time(s.time);
  terms_.constraints(s);
  terms_.refuse_lost(s);
  s.lambda.setZero(terms_.structure.constraints);
  if (!settle_anew(s)) refuse_unsettled(settings_.most_iterations, s.time);
}

/// After constraints(), with M + alpha Phi_q^T Phi_q.
bool Index3::settle_anew(State& s) {
  terms_.factorize(s, {0.0, 0.0, weight_ = penalty(std::max(shortest, settings_.own_step))});
  return settle(s, settings_.most_iterations);
}

bool Index3::settle(State& s, int most) {
  terms_.forces(s);
  terms_.model.constraint_accelerations(s.q.data(), s.v.data(), terms_.gamma.data());
  terms_.gamma -= left_;
  terms_.violation(s.a, terms_.gamma);
  return terms_.settle(s, weight_, settled, most) > 0;
}

void Index3::refresh(State& s) {
  const FlushDenormals scope;
  const Team team(settings_.threads, settings_.threads_from);
  terms_.model.at_time(s.time);
  terms_.constraints(s);
  if (!needs_own_ && weight_ > 0.0) needs_own_ = !settle(s, 1) && !goes_on_to_settle(terms_, s, weight_);
  if (needs_own_ || weight_ == 0.0) settle_anew(s);
}

int Index3::step(State& s, double h, double t_end) {
  const FlushDenormals scope;
  const Team team(settings_.threads, settings_.threads_from);
  penalty_ = penalty(h);
  predict(s, h, t_end);
  if (is_short(h)) return 0;
  for (int iteration = 1; iteration <= settings_.most_iterations; ++iteration) {
    const bool done = correct(s, h) < tolerance_;
    if (done) project_velocities(s, tolerance_ / h);
    terms_.constraints(s);
    if (done || iteration <= settings_.multiplier_iterations) s.lambda += penalty_ * terms_.phi;
    if (!done) continue;
    terms_.refuse_lost(s);
    project_accelerations(s, tolerance_ / (h * h));
    if (!terms_.definite) weight_ = 0.0;
    return iteration;
  }
  throw Error(
      ErrorCode::numerical,
      fmt::format("no convergence at t = {} s in {} iterations: the last correction is {:.2e} m, allowed "
                  "is below {:.3g} m; no shorter step is tried",
                  s.time, settings_.most_iterations, terms_.correction.norm(), tolerance_));
}

void Index3::refuse_unstable(const State& s, double h) {
  if (steps_ % steps_between_checks == 0) frequency_ = highest_->at(s, weight_ = penalty_);
  ++steps_;
  mbs::refuse_unstable("index-3 formulation", settings_.beta, frequency_, s.time, h);
}

/// The penalty of the tangent at hand, which refresh() uses, the highest frequency and when it is looked at,
/// whether refresh() needs a tangent of its own, what the projection left, and that tangent.
void Index3::remember(std::vector<double>& to) const {
  to.insert(to.end(), {weight_, frequency_, static_cast<double>(steps_), needs_own_ ? 1.0 : 0.0});
  to.insert(to.end(), left_.begin(), left_.end());
  terms_.remember(to);
}

void Index3::recall(std::span<const double> memory) {
  const auto head = static_cast<std::size_t>(4 + left_.size());
  check_memory(memory.size() >= head);
  terms_.recall(memory.subspan(head));
  std::copy_n(memory.begin() + 4, left_.size(), left_.begin());
  weight_ = memory[0], frequency_ = memory[1], steps_ = static_cast<long>(memory[2]);
  needs_own_ = memory[3] != 0.0;
}

bool Index3::is_short(double h) const { return h < short_part * settings_.own_step; }

void Index3::predict(State& s, double h, double t_end) {
  Setting{"index-3 formulation", "the step", h}.positive();
  if (settings_.beta < 0.25) refuse_unstable(s, h);
  extrapolate(s, h);
  s.time = t_end;
  terms_.model.at_time(t_end);
  if (!settings_.carry_multipliers && !is_short(h)) s.lambda.setZero();
  terms_.constraints(s);
}

/// Accelerations stay as they are.
void Index3::extrapolate(State& s, double h) {
  const Timed timed(Task::update);
  double* const q = s.q.data();
  double* const v = s.v.data();
  const double* const a = s.a.data();
  share(terms_.structure.variables, [=](int first, int last) {
    for (int i = first; i < last; ++i) q[i] += h * v[i] + 0.5 * h * h * a[i], v[i] += h * a[i];
  });
}

TangentFactors Index3::tangent_factors(double h) const {
  const double scale = settings_.beta * h * h;
  return {gamma * h, scale, scale * penalty(h)};
}

/// One of Newton's iterations: the Euclidean norm of the change in q.
double Index3::correct(State& s, double h) {
  const TangentFactors factors = tangent_factors(h);
  weight_ = factors.penalty;
  terms_.factorize(s, factors);
  terms_.forces(s);
  terms_.weights = s.lambda + penalty_ * terms_.phi;
  const double norm = terms_.correct(s, terms_.weights, factors.stiffness);
  add_correction(s, h);
  return norm;
}

void Index3::add_correction(State& s, double h) {
  const Timed timed(Task::update);
  const double to_v = gamma / (settings_.beta * h), to_a = 1.0 / (settings_.beta * h * h);
  double* const q = s.q.data();
  double* const v = s.v.data();
  double* const a = s.a.data();
  const double* const d = terms_.correction.data();
  share(terms_.structure.variables, [=](int first, int last) {
    for (int i = first; i < last; ++i) q[i] += d[i], v[i] += to_v * d[i], a[i] += to_a * d[i];
  });
}

/// Before constraints() at the end, so with the gradients that T was made of.
void Index3::project_velocities(State& s, double tolerance) {
  const Timed timed(Task::velocity_projection);
  terms_.model.constraint_rates(s.q.data(), terms_.phi.data());
  terms_.violation(s.v, terms_.phi);
  const bool may_grow = settings_.beta < 0.25;
  const double before = may_grow ? terms_.error.norm() : 0.0;
  for (int k = 1; k <= settings_.projections; ++k) {
    terms_.project(s.v, weight_);
    if (terms_.correction.norm() < tolerance) return;
    if (k < settings_.projections || may_grow) terms_.violation(s.v, terms_.phi);
  }
  if (may_grow) refuse_growth(s, before);
}

/// Below 1e-8 |Phi_q| |q'| it is rounding and the tolerance of Newton's iteration.
void Index3::refuse_growth(const State& s, double before) {
  const double left = terms_.error.norm(), grows = newmark_growth(settings_.beta),
               size = Eigen::Map<const Eigen::VectorXd>(terms_.matrices.jacobian.data(),
                                                        terms_.structure.jacobian.size())
                          .norm();
  if (left * grows <= before || left <= 1e-8 * size * s.v.norm()) return;
  throw Error(
      ErrorCode::numerical,
      fmt::format("index-3 formulation: with beta = {:.4g} errors of constrained velocities grow by {:.4g} "
                  "in a step, and {:.3g} of them is left by projections = {} at t = {} s; allowed is below "
                  "{:.3g}: more projections, a greater penalty, longer steps, or beta = 0.25",
                  settings_.beta, grows, left / before, settings_.projections, s.time, 1.0 / grows));
}

void Index3::project_accelerations(State& s, double tolerance) {
  const Timed timed(Task::acceleration_projection);
  terms_.model.constraint_accelerations(s.q.data(), s.v.data(), terms_.gamma.data());
  terms_.violation(s.a, terms_.gamma);
  for (int k = 1; k <= settings_.projections; ++k) {
    terms_.project(s.a, weight_);
    terms_.violation(s.a, terms_.gamma);
    s.lambda += weight_ * terms_.error;
    if (terms_.correction.norm() < tolerance) break;
  }
  left_.swap(terms_.error);
}

}  // namespace tandem::mbs
