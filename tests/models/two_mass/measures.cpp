// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "two_mass/measures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "two_mass/mode_fit.hpp"

namespace tandem::two_mass {
namespace {

constexpr double fitted_cycles = 10.0;
constexpr double least_amplitude = 0.01;  // of C11, below which a phase has no meaning
constexpr double largest_residual =
    0.5;  // of the amplitude (fitted or C11), beyond which the fit has no meaning

}  // namespace

Measures::Measures(const Model& model, double frequency_ratio, double t_stop)
    : model_(model), frequency_ratio_(frequency_ratio), t_stop_(t_stop) {
  const Motion start = model.exact(0.0);
  energy0_ = model.energy(start);
  largest_ = std::max(std::abs(start.x1), std::abs(start.x2));
  fast_.reserve(static_cast<std::size_t>(t_stop / model.h1) + 2);
  slow_.reserve(static_cast<std::size_t>(t_stop / model.h2) + 2);
}

bool Measures::samples(int subsystem, const History& history, std::int64_t first, std::int64_t last) {
  const bool both = history.outputs() == 4;
  for (std::int64_t row = first; row <= last; ++row) {
    const auto y = history.values(row);
    if (subsystem == 0) fast_.push_back({history.time(row), y[0], y[1]});
    if (subsystem == 1 || both) slow_.push_back({history.time(row), y[both ? 2 : 0], y[both ? 3 : 1]});
    if (std::abs(y[0]) > limit()) fail("a displacement exceeded 1e8 times the largest at the start");
  }
  return !failed_;
}

void Measures::between_rounds() {
  const double e = model_.energy({fast_.back().x1, fast_.back().v1, slow_.back().x2, slow_.back().v2});
  const double error = (e - energy0_) / energy0_;
  exchange_sum_ += error * error;
  ++exchanges_;
}

void Measures::fail(const std::string& note) {
  failed_ = true;
  note_ = note + " at t = " + std::to_string(fast_.back().time) + " s";
}

/// (FR/N) sqrt(sum/count), N the number of fast cycles (of 1 s each).
double Measures::scaled(double sum, std::size_t count) const {
  return frequency_ratio_ / t_stop_ * std::sqrt(sum / static_cast<double>(count));
}

void Measures::set_position_errors(Figures& f) const {
  double squares = 0.0, exact_squares = 0.0, errors = 0.0;
  for (const Node& n : fast_) {
    const double exact = model_.exact(n.time).x1, error = n.x1 - exact;
    squares += n.x1 * n.x1;
    exact_squares += exact * exact;
    errors += error * error;
  }
  const auto count = static_cast<double>(fast_.size());
  f.position_error = scaled(errors / squares * count, fast_.size());
  f.position_error_exact = scaled(errors / exact_squares * count, fast_.size());
}

std::vector<double> Measures::energy_errors() const {
  std::vector<double> errors;
  errors.reserve(fast_.size());
  std::size_t k = 1;
  const TimeTolerance tolerance(0.0);
  for (const Node& n : fast_) {
    while (k < slow_.size() && tolerance.before(slow_[k].time, n.time)) ++k;
    if (k >= slow_.size()) break;
    const SlowNode &a = slow_[k - 1], &b = slow_[k];
    const double h = b.time - a.time, s = (n.time - a.time) / h, chord = (b.x2 - a.x2) / h;
    const double c2 = 3.0 * chord - 2.0 * a.v2 - b.v2, c3 = a.v2 + b.v2 - 2.0 * chord;
    const double x2 = a.x2 + h * s * (a.v2 + s * (c2 + s * c3));
    const double v2 = a.v2 + s * (2.0 * c2 + 3.0 * s * c3);
    errors.push_back((model_.energy({n.x1, n.v1, x2, v2}) - energy0_) / energy0_);
  }
  return errors;
}

Figures Measures::figures() const {
  Figures f;
  f.failed = failed_;
  f.note = note_;
  if (failed_) return f;
  set_position_errors(f);
  const std::vector<double> energies = energy_errors();
  double sum = 0.0;
  for (const double e : energies) sum += e * e;
  f.energy_error = scaled(sum, energies.size());
  if (exchanges_ > 0) f.exchange_energy_error = scaled(exchange_sum_, exchanges_);
  fit_fast_mode(f);
  return f;
}

void Measures::fit_fast_mode(Figures& f) const {
  if (t_stop_ < fitted_cycles) {
    f.note = "no fit of the fast mode: the run has fewer than ten fast cycles";
    return;
  }
  const TimeTolerance tolerance(0.0);
  ModeFit fit(model_.omega1, model_.omega2, t_stop_ - 0.5 * fitted_cycles);
  for (const Node& n : fast_)
    if (!tolerance.before(n.time, t_stop_ - fitted_cycles)) fit.add(n.time, n.x1);
  const ModeFit::Mode mode = fit.solve();
  if (mode.residual > largest_residual * std::max(mode.amplitude, std::abs(model_.c11))) {
    f.note = "no fit of the fast mode: the rest of x1 is above half of its amplitude";
    return;
  }
  f.amplitude_error = mode.amplitude / std::abs(model_.c11) - 1.0;
  const double lead = mode.phase - model_.phase1 - (model_.c11 < 0.0 ? std::numbers::pi : 0.0);
  if (mode.amplitude < least_amplitude * std::abs(model_.c11))
    f.note = "no phase: the fast mode is damped below 1 % of its amplitude";
  else
    f.phase_error = std::remainder(lead, 2.0 * std::numbers::pi);
}

}  // namespace tandem::two_mass
