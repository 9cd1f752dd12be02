// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/engine/integrators/runge_kutta.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tandem::engine {
namespace {

constexpr double exactness = 1e-12;  // of a step
constexpr int most_trials = 200;     // halving alone needs 60
constexpr double touch = 1e-150;  // where a signal is zero and has not changed yet: it may do so next to it

/// Steps between which a signal changes its sign, with its values there.
struct Bracket {
  double low, high, at_low, at_high;
  int which;
  bool raised = false, lowered = false;  ///< by the last trial

  double guess() const {
    if (!(at_low * at_high < 0.0)) return 0.5 * (low + high);
    return high - at_high * (high - low) / (at_high - at_low);
  }
  void raise(double h, double value) {
    if (raised) at_high *= 0.5;
    const bool touches = value == 0.0 && std::abs(at_low) > touch;  // not twice: it may stay there
    low = h, at_low = touches ? -std::copysign(touch, at_high) : value, raised = true, lowered = false;
  }
  void lower(double h, int by, double value) {
    at_low *= by != which ? 0.0 : lowered ? 0.5 : 1.0;
    high = h, at_high = value, which = by, lowered = true, raised = false;
  }
};

}  // namespace

void RungeKutta4::restart(System& system, double, Restart) {
  ++statistics_.restarts;
  for (auto* list : {&start_, &rate_, &sum_, &first_}) list->resize(static_cast<std::size_t>(system.size()));
}

double RungeKutta4::advance(System& system, double t, double t_end) {
  std::copy_n(system.states(), system.size(), start_.data());
  system.evaluate_again(t);
  if (locate_events_ && system.changed() >= 0) return t;  // by an input that has jumped
  system.read_rates(first_.data());
  step(system, t, t_end - t);
  system.evaluate(t_end);
  return !locate_events_ || system.changed() < 0 ? t_end : locate(system, t, t_end);
}

/// From start_ with its rates first_.
void RungeKutta4::step(System& system, double t, double h) {
  ++statistics_.steps, statistics_.rate_evaluations += 4;
  const int n = system.size();
  double* const x = system.states();
  const double *const start = start_.data(), *const first = first_.data();
  double *const rate = rate_.data(), *const sum = sum_.data();
  for (int i = 0; i < n; ++i) sum[i] = first[i], x[i] = start[i] + 0.5 * h * first[i];
  system.rates(t + 0.5 * h, rate);
  for (int i = 0; i < n; ++i) sum[i] += 2.0 * rate[i], x[i] = start[i] + 0.5 * h * rate[i];
  system.rates(t + 0.5 * h, rate);
  for (int i = 0; i < n; ++i) sum[i] += 2.0 * rate[i], x[i] = start[i] + h * rate[i];
  system.rates(t + h, rate);
  for (int i = 0; i < n; ++i) x[i] = start[i] + h / 6.0 * (sum[i] + rate[i]);
}

void RungeKutta4::try_step(System& system, double t, double h) {
  step(system, t, h);
  system.evaluate(t + h);
}

/// The Illinois method (M. Dowell, P. Jarratt, BIT 11 (1971) 168) on the signal that changes its sign first,
/// halving where that is another than before: at `low` none has changed, at `high` one has.
double RungeKutta4::locate(System& system, double t, double t_end) {
  Bracket b{0.0, t_end - t, 0.0, 0.0, system.changed()};
  const double close =
      std::max(exactness * b.high, 4.0 * std::numeric_limits<double>::epsilon() * std::abs(t_end));
  b.at_high = system.watched(b.which);
  std::copy_n(start_.data(), system.size(), system.states());
  system.evaluate(t);
  b.at_low = system.watched(b.which);
  for (int trial = 0; b.high - b.low > close && trial < most_trials; ++trial) {
    const double h = std::clamp(b.guess(), b.low + 0.5 * close, b.high - 0.5 * close);
    try_step(system, t, h);
    const int now = system.changed();
    now < 0 ? b.raise(h, system.watched(b.which)) : b.lower(h, now, system.watched(now));
  }
  try_step(system, t, b.high);
  return t + b.high;
}

}  // namespace tandem::engine
