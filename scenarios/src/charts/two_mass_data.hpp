// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "two_mass/experiment.hpp"

namespace tandem::charts {

using two_mass::Scheme;

/// What the charts take from a row of sweep.csv or work.csv. Errors are fractions; NaN where the cell is
/// empty.
struct Result {
  Scheme scheme;
  double frequency_ratio = 0.0;
  double position_error = 0.0;   ///< column position_error_exact, which has no ceiling
  double energy_error = 0.0;     ///< sweep.csv only
  double amplitude_error = 0.0;  ///< of the fast mode; signed
  double exchanges = 0.0;
  double steps_per_cycle = 0.0;  ///< work.csv only
  double seconds = 0.0;          ///< work.csv only; NaN if the run failed
  bool failed = false;

  /// The one figure by which schemes are compared: the larger of position error and size of the amplitude
  /// error, since a run whose fast mode has been damped away may still have a small position error. Infinite
  /// if the run failed or one of them has no meaning.
  double error() const;
};

/// x1 [m] and energy error over time [s], of one run.
struct Trace {
  Scheme scheme;
  double frequency_ratio = 0.0;
  std::vector<double> time, x1, x1_exact, energy_error;
};

/// Each throws Error naming file, line and column if something else stands there than `tandem sweep two_mass`
/// writes.
std::vector<Result> read_sweep(const std::filesystem::path& file);
std::vector<Result> read_work(const std::filesystem::path& file);
/// In the order of the file. A row that differs from the one before in scheme or ratio begins a new trace.
std::vector<Trace> read_traces(const std::filesystem::path& file);

/// "slowest-first, lagrange3", "fastest-first, lagrange3 / mean" (to the fast side / to the slow side).
std::string name_of(const Scheme& scheme);
/// The same degree of Lagrange polynomial both ways: that degree; -1 for any other scheme.
int equal_degree(const Scheme& scheme);
/// Takes part in the comparison of schemes: equal reconstructions both ways, or smoothing.
bool compared(const Scheme& scheme);

}  // namespace tandem::charts
