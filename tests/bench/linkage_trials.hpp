// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "bench/bench.hpp"

namespace tandem::bench {

/// A run of `tandem bench simbody`.
struct LinkageTrial {
  std::string code, start, method, status;
  int loops;
  double error;    ///< [m] NaN where the run ended early
  double seconds;  ///< processor time

  bool ok() const { return status == "ok"; }
  /// Rod, PointOnLine (Simbody); index3, penalty, index1 (tandem): the method's first word.
  std::string family() const { return method.substr(0, method.find(' ')); }
};

/// What an error costs.
struct Cost {
  double seconds = 0.0;
  bool bound = false;  ///< the cheapest run is more accurate than asked: it takes at most that
  std::string method;
};

/// Of runs of one start and number of loops, those that are ok: the least time over the methods, each
/// interpolated between the logarithms of its neighbouring points on its Pareto front. None if no method
/// is so accurate.
std::optional<Cost> cost_of(const std::vector<LinkageTrial>& runs, double error);

/// The times at an error of 1 mm of both codes, and how many times as long Simbody takes, a row for each
/// start and number of loops.
Table ratios(const std::vector<LinkageTrial>& runs);

}  // namespace tandem::bench
