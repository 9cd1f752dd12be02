// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/stability/super_step.hpp"

namespace tandem::stability {

/// One mode of the coupled system, as the system undivided has it and as the scheme makes it.
struct Mode {
  double rate;              ///< Re mu [1/s] of the system undivided
  double frequency;         ///< of the system undivided: |Im mu| / 2 pi [Hz]; 0: it does not swing
  double damping;           ///< its damping ratio, -Re mu / |mu|
  double scheme_frequency;  ///< of the scheme: the nearest that its multiplier over a super-step allows [Hz]
  double scheme_damping;    ///< -ln |lambda| / (T |mu|)
  double growth;            ///< |lambda|, over one super-step
  Eigen::VectorXd parts;    ///< how much each state takes part: participation factors
  /// How much of the scheme's mode is the true one, 0 to 1 (the modal assurance criterion of its states).
  double likeness;

  /// Whether the scheme has such a mode at all; if not, its numbers say nothing.
  bool is_kept() const { return likeness >= 0.5; }
  double detuning() const { return frequency > 0.0 ? scheme_frequency / frequency - 1.0 : 0.0; }
};

/// What a scheme makes of a scenario.
struct Stability {
  SuperStep step;
  double radius;                    ///< spectral radius of step.map
  std::vector<std::string> states;  ///< "fast.x1"
  std::vector<Mode> modes;          ///< the fastest first
  std::string unknown;              ///< why modes are not known; empty: they are
  double rate =
      0.0;  ///< [1/s]: of what grows fastest in the system undivided; 0: nothing does, or it is not known

  /// Whether something grows that does not, or not as fast, in the system undivided.
  bool is_unstable() const;
  /// The names of the states that take part in a mode at least a third as much as the one that takes part most.
  std::string mostly(const Mode& mode) const;
};

/// Whether what a super-step multiplies by `radius` at most grows no faster than by `rate` [1/s].
bool is_stable(const SuperStep& step, double radius, double rate);

/// Throws Error as super_step() does.
Stability stability(const scenario::Scenario& scenario, const Builtins& builtins);

}  // namespace tandem::stability
