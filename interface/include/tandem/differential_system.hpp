// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace tandem {

/// The smallest magnitude of a watched signal: root finding multiplies two of them.
inline constexpr double smallest_sign = 0x1p-511;

/// x' = f(t, x) with watched signals (event indicators), as an integrator sees it that knows no more of it.
/// What evaluates throws Error(numerical) where it has no value; a shorter step may then be tried.
class DifferentialSystem {
 public:
  virtual ~DifferentialSystem() = default;
  virtual int size() const = 0;  ///< number of states
  /// x; whoever integrates writes its trials here.
  virtual double* states() = 0;
  virtual std::vector<std::string> state_names() const = 0;
  /// By state the size that it usually has, which scales its absolute tolerance.
  virtual std::vector<double> nominals() const {
    return std::vector<double>(static_cast<std::size_t>(size()), 1.0);
  }
  /// f(t, x), size() numbers, per second. Watched signals need not follow.
  virtual void rates(double t, double* dx) = 0;
  /// All that follows from t [s] and x, watched signals included.
  virtual void evaluate(double t) = 0;
  /// The same after evaluate(t) at this t and x, where inputs alone may have changed since.
  virtual void evaluate_again(double t) = 0;

  virtual int watched_signals() const = 0;
  /// After evaluate(): a number of the sign of each, of smallest_sign or more.
  virtual void watched_signs(double* signs) const = 0;
  /// After evaluate(): the first signal with another sign than at the last event; -1: none.
  virtual int changed() const = 0;

  /// By how much rates are off beyond rounding, relative to what they follow: where an iteration stops.
  virtual double rate_error() const { return 0.0; }
  /// Where a rate is not finite: what made it so; empty if that is not known.
  virtual std::string not_finite() const { return {}; }
};

/// Why an integrator begins anew. At an event, or where an input jumps, it may use what it knows of the
/// lengths of its steps. Where a state is set it may not, so that what follows depends on the state alone.
enum class Restart { event, state };

/// Moves the states of such a system by steps of its own.
class AdaptiveIntegrator {
 public:
  virtual ~AdaptiveIntegrator() = default;
  /// Throws Error(invalid_argument) for a setting that does not fit these states.
  virtual void check_fit(const std::vector<std::string>& state_names) const = 0;
  /// Before the first step, and after states, held values or the inputs' course have changed at once.
  virtual void restart(DifferentialSystem& system, double t, Restart why) = 0;
  /// From t to t_end, or to the end of one of its steps, or to the first change of a watched sign on the way,
  /// just past it. The system is as at t, but for what follows from inputs that have jumped since, and is
  /// left as at the time that it returns. Throws Error(numerical) if it can't. Precondition: there are
  /// states.
  virtual double advance(DifferentialSystem& system, double t, double t_end) = 0;
};

}  // namespace tandem
