// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tandem::charts {

/// A row of what `tandem bench simbody` writes.
struct LinkageRun {
  std::string code, start, method, status;
  int loops;
  double error;    ///< [m] NaN where the run ended early
  double seconds;  ///< processor time

  bool ok() const { return status == "ok"; }
  /// Rod, PointOnLine (Simbody); index3, penalty, index1 (tandem): the method's first word.
  std::string family() const { return method.substr(0, method.find(' ')); }
};

/// Throws Error for a file that is no such table.
std::vector<LinkageRun> read_linkage_runs(const std::filesystem::path& file);

/// What an error costs.
struct Cost {
  double seconds = 0.0;
  bool bound = false;  ///< the cheapest run is more accurate than asked: it takes at most that
  std::string method;
};

/// Of runs of one start and number of loops, those that are ok: the least time over the methods, each
/// interpolated between the logarithms of its neighbouring points on its Pareto front. None if no method
/// is so accurate.
std::optional<Cost> cost_of(const std::vector<LinkageRun>& runs, double error);

/// The times at an error of 1 mm of both codes, and how many times as long Simbody takes, a line for each
/// start and number of loops.
std::string ratios(const std::vector<LinkageRun>& runs);

}  // namespace tandem::charts
