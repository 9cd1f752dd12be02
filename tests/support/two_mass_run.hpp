// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "exact_masses.hpp"
#include "tandem/coordinator/coordinator.hpp"
#include "two_mass/model.hpp"

namespace tandem::test {

/// Makes one side of the two-mass test.
using MakeSide = std::function<std::unique_ptr<Subsystem>(const two_mass::Model&)>;

MakeSide exact(const ExactMass::Options& options);
MakeSide exact_fast();
MakeSide exact_slow();
MakeSide real_fast(bool gives_force = false);  ///< two_mass.fast, .fast_force
MakeSide real_slow(bool reads_force = false);  ///< two_mass.slow, .slow_force
MakeSide reusing_slow();                       ///< two_mass.slow that reuses its acceleration
/// The same side, but it can't shorten a step.
MakeSide without_landing(MakeSide side);

/// What crosses the coupling: x1 and x2; or the force in the spring k2, from the side that is named, and the
/// other's displacement.
enum class Crossing { displacements, force_from_fast, force_from_slow };

/// A run of the two-mass test.
struct TwoMassRun {
  two_mass::Settings settings;
  Schedule::Kind schedule = Schedule::Kind::slowest_first;
  std::string to_fast = "lagrange3", to_slow = "lagrange3";
  StartKind start = StartKind::automatic;
  double t_start = 0.0, t_stop = 1.0;
  Crossing crossing = Crossing::displacements;
  Lag lag = Lag::none;  ///< on what the slow side reads
  MakeSide fast = exact_fast(), slow = exact_slow();

  /// Exact sides for `crossing`.
  void set_exact_sides(Crossing crossing, double exact_until = -std::numeric_limits<double>::infinity());
  void set_scheme(const std::string& both_ways) { to_fast = to_slow = both_ways; }
};

/// Both modes start at phase 0.8, so that no velocity is zero (which hides orders).
TwoMassRun run_at(double frequency_ratio, Schedule::Kind schedule);

/// A side's displacement and velocity after an own step.
struct Node {
  double t, x, v;
};

struct TwoMassResult {
  two_mass::Model model;
  std::vector<Node> fast, slow;  ///< from the first sample on
  std::vector<two_mass::Motion>
      turns;  ///< the states last computed, after each turn (parallel: each side of a round)
  std::vector<std::string> notes;
  std::int64_t exchanges;
  StartKind start = StartKind::cold;
  int start_passes = 0;
};

TwoMassResult run(const TwoMassRun& what);

/// Root mean square over the nodes from t = `from` on of the distance to the exact motion, each side by
/// itself, velocity counted by its mode's frequency: sqrt(mean(dx^2 + (dv/w)^2)) [m].
struct GlobalError {
  double fast, slow;
};
GlobalError error_of(const TwoMassResult& result, double from = 0.0);
/// The thesis' position error: (FR / cycles) rms(x1 - exact) / rms(x1), over all nodes of the fast side.
double position_error(const TwoMassResult& result);

/// log2 of the ratio of two errors: the order seen when the steps are halved.
double order(double coarse, double fine);

}  // namespace tandem::test
