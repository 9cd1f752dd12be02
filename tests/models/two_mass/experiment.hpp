// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "two_mass/measures.hpp"

namespace tandem::two_mass {

/// One way to couple the two sides, by the words of files and tables. Schedule "monolithic": both masses in
/// one subsystem, nothing to reconstruct.
struct Scheme {
  std::string schedule, to_fast, to_slow;
  bool monolithic() const { return schedule == "monolithic"; }
  bool operator==(const Scheme&) const = default;
};

/// The schemes of the sweep: schedules x equal degrees (all 25 pairs with `pairs`), hermite, matched hold,
/// smoothing. All can be honoured.
std::vector<Scheme> sweep_schemes(bool pairs);

/// The frequency ratios of the sweep: the and fourteen more that are not whole.
const std::vector<double>& sweep_ratios();

/// A run of the test with one scheme.
struct Case {
  Scheme scheme;
  double frequency_ratio = 30.0;
  double cycles = 100.0;           ///< of the fast mode, 1 s each
  double steps_per_cycle = 100.0;  ///< of each side, in a cycle of its own mode
  bool reuse_acceleration = false;
};

struct Outcome {
  Figures figures;
  std::int64_t exchanges = 0;  ///< calls of advance
  std::int64_t evaluations =
      0;  ///< of a right-hand side: Runge-Kutta 4 a step (monolithic 8: two masses), trapezoidal rule 2
};

/// Runs the case and judges it.
Outcome run_case(const Case& c);
/// The same; `look` may take more from the measures (for traces).
Outcome run_case(const Case& c, const std::function<void(const Model&, const Measures&)>& look);
/// Runs it without measures, for its cost alone: seconds of the stepping loop.
double time_case(const Case& c);

/// Seconds of a run's stepping loop, and of the calls of each side within it (one clock reading before and
/// after each).
struct Profile {
  double total, fast, slow;
};
Profile profile_case(const Case& c);

}  // namespace tandem::two_mass
