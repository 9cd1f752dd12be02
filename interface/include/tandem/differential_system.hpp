// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace tandem {

/// x' = f(t, x), and signals whose signs are watched, as an integrator sees them that knows no more of it. What
/// evaluates may throw Error.
class DifferentialSystem {
 public:
  virtual ~DifferentialSystem() = default;
  virtual int size() const = 0;  ///< number of states
  virtual double* states() = 0;
  virtual std::vector<std::string> state_names() const = 0;
  /// f at t and these states.
  virtual void rates(double t, double* dx) = 0;
  /// It is as at t and these states.
  virtual void evaluate(double t) = 0;
  /// The same where nothing has changed since but its inputs.
  virtual void evaluate_again(double t) = 0;

  virtual int watched_signals() const = 0;
  /// After evaluate(): a number of the signal's sign, never zero.
  virtual double watched_sign(int signal) const = 0;
  /// After evaluate(): a signal with another sign than was seen last; -1: none.
  virtual int changed() const = 0;

  /// By how much rates are off, relative to the size of what they follow, beyond rounding.
  virtual double error_of_loops() const { return 0.0; }
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
  /// From t to t_end, or to the end of one of its steps, or to the first change of a watched sign on the way, just
  /// past it. The system is as at t, but for what follows from inputs that have jumped since, and is left as at the
  /// time that it returns. Throws Error(numerical) if it can't. Precondition: there are states.
  virtual double advance(DifferentialSystem& system, double t, double t_end) = 0;
};

}  // namespace tandem
