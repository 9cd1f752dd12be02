// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/sources/stepper.hpp"

#include <fmt/format.h>

#include <cmath>

#include "tandem/error.hpp"

namespace tandem {
namespace {

[[noreturn]] void refuse(const std::string& name, double value, const std::string& allowed) {
  throw Error(ErrorCode::invalid_argument,
              fmt::format("parameter '{}' is {}; allowed is {}", name, value, allowed));
}

/// A count.
int whole(Parameters& p, const std::string& name, int otherwise, int most = 1000000000) {
  const double value = p.number(name, otherwise);
  if (value == std::floor(value) && value >= 1.0 && value <= most) return static_cast<int>(value);
  refuse(name, value, fmt::format("a whole number from 1 to {}", most));
}

/// Among the settings 0 stands for the default.
double above_zero(Parameters& p, const std::string& name, double otherwise) {
  const bool given = p.has(name);
  const double value = p.number(name, otherwise);
  if (given && !(value > 0.0)) refuse(name, value, "a number above 0, or to leave it out");
  return value;
}

void take(Parameters& p, mbs::Index3Settings& s) {
  s.penalty = above_zero(p, "penalty", s.penalty);
  s.beta = p.number("beta", s.beta);
  s.tolerance = above_zero(p, "tolerance", s.tolerance);
  s.most_iterations = whole(p, "most_iterations", s.most_iterations);
  s.multiplier_iterations = whole(p, "multiplier_iterations", s.multiplier_iterations);
  s.projections = whole(p, "projections", s.projections);
  s.carry_multipliers = p.flag("carry_multipliers", s.carry_multipliers);
  s.solver = p.text("solver", s.solver);
  s.threads = whole(p, "threads", s.threads, 256);
  s.threads_from = whole(p, "threads_from", s.threads_from);
}

template <class Stabilized>
void take_stabilized(Parameters& p, Stabilized& s) {
  s.penalty = above_zero(p, "penalty", s.penalty);
  s.xi = p.number("xi", s.xi);
  s.omega = p.number("omega", s.omega);
  s.solver = p.text("solver", s.solver);
}

void take_integrator(Parameters& p, mbs::StepperSettings& s) {
  if (s.integrator == "newmark") {
    s.newmark.beta = p.number("beta", s.newmark.beta);
    s.newmark.tolerance = above_zero(p, "tolerance", s.newmark.tolerance);
    s.newmark.most_iterations = whole(p, "most_iterations", s.newmark.most_iterations);
  }
  if (s.integrator == "generalized_alpha") {
    auto& alpha = s.generalized_alpha;
    alpha.spectral_radius = p.number("spectral_radius", alpha.spectral_radius);
    alpha.tolerance = above_zero(p, "tolerance", alpha.tolerance);
    alpha.most_iterations = whole(p, "most_iterations", alpha.most_iterations);
  }
}

}  // namespace

Words stepper_words() {
  return words_by(Setter::client, {"formulation", "integrator", "penalty", "beta", "tolerance",
                                   "most_iterations", "multiplier_iterations", "projections",
                                   "carry_multipliers", "solver", "xi", "omega", "spectral_radius"}) +
         words_by(Setter::operator_only, {"threads", "threads_from"});
}

mbs::StepperSettings take_stepper(Parameters& p) {
  mbs::StepperSettings s;
  s.formulation = p.text("formulation", s.formulation);
  s.integrator = p.text("integrator", s.integrator);
  if (s.formulation == "index3") {
    take(p, s.index3);
    return s;
  }
  if (s.formulation == "penalty") take_stabilized(p, s.penalty);
  if (s.formulation == "index1") {
    take_stabilized(p, s.index1);
    s.index1.multiplier_iterations = whole(p, "multiplier_iterations", s.index1.multiplier_iterations);
    s.index1.carry_multipliers = p.flag("carry_multipliers", s.index1.carry_multipliers);
  }
  take_integrator(p, s);
  return s;
}

}  // namespace tandem
