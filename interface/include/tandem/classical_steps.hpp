// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace tandem {

/// Steps between which a signal changes its sign, with its values there: for the Illinois method (M. Dowell,
/// P. Jarratt, BIT 11 (1971) 168) on the signal that changes first, halving where that is another than
/// before.
struct SignBracket {
  /// Where a signal is zero and has not changed yet: it may do so next to it.
  static constexpr double touch = 1e-150;
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

/// Steps of the classical Runge-Kutta method of order 4 (W. Kutta, Z. Math. Phys. 46 (1901) 435) of a system
/// x' = f(t, x) with signals whose signs are watched. A change of sign is located by steps of other lengths
/// from the same beginning, to 1e-12 of the step or the rounding of time, so the order is kept across events.
/// System has:
/// - `int size() const`: the number of states.
/// - `double* states()`: x.
/// - `void rates(double t, double* dx)`: f at t and these states.
/// - `void evaluate(double t)`: the system is as at t.
/// - `void evaluate_again(double t)`: the same where nothing has changed since but its inputs.
/// - `void read_rates(double* dx)`: f, after an evaluation.
/// - `int changed() const`: after an evaluation, a signal with another sign than was seen last; -1: none.
/// - `double watched(int signal) const`: its value.
template <class System>
class ClassicalSteps {
 public:
  /// For so many states.
  void resize(int size) {
    for (auto* list : {&start_, &rate_, &sum_, &first_}) list->resize(static_cast<std::size_t>(size));
  }

  /// From t to t_end; with `locate` only to the first change of a sign on the way, just past it, or to none
  /// where inputs have made one at t. Returns the time, as which the system is left.
  double advance(System& system, double t, double t_end, bool locate) {
    std::copy_n(system.states(), system.size(), start_.data());
    system.evaluate_again(t);
    if (locate && system.changed() >= 0) return t;  // by an input that has jumped
    system.read_rates(first_.data());
    try_step(system, t, t_end - t, t_end);
    return !locate || system.changed() < 0 ? t_end : find_change(system, t, t_end);
  }
  long steps() const { return steps_; }

 private:
  static constexpr double exactness = 1e-12;  // of a step
  static constexpr int most_trials = 200;     // halving alone needs 60

  void try_step(System& system, double t, double h, double t_end) {
    step(system, t, h);
    system.evaluate(t_end);
  }

  /// From start_ with its rates first_.
  void step(System& system, double t, double h) {
    ++steps_;
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

  /// At `low` no sign has changed, at `high` one has.
  double find_change(System& system, double t, double t_end) {
    SignBracket b{0.0, t_end - t, 0.0, 0.0, system.changed()};
    const double close =
        std::max(exactness * b.high, 4.0 * std::numeric_limits<double>::epsilon() * std::abs(t_end));
    b.at_high = system.watched(b.which);
    std::copy_n(start_.data(), system.size(), system.states());
    system.evaluate(t);
    b.at_low = system.watched(b.which);
    for (int trial = 0; b.high - b.low > close && trial < most_trials; ++trial) {
      const double h = std::clamp(b.guess(), b.low + 0.5 * close, b.high - 0.5 * close);
      try_step(system, t, h, t + h);
      const int now = system.changed();
      now < 0 ? b.raise(h, system.watched(b.which)) : b.lower(h, now, system.watched(now));
    }
    try_step(system, t, b.high, t + b.high);
    return t + b.high;
  }

  std::vector<double> start_, rate_, sum_, first_;
  long steps_ = 0;
};

}  // namespace tandem
