// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "tandem/engine/description.hpp"

namespace tandem::engine_linkage {

/// The bar's speed from the equation of one degree of freedom with the engine's states (monolithic.hpp), by
/// CVODE (Adams) at 1e-10, events located.
class Truth {
 public:
  static constexpr double grid = 1e-4;  ///< [s]

  /// engine: with the input `speed`.
  Truth(const engine::Description& engine, int loops, double t_stop);

  /// [rad/s], at a multiple of the grid up to t_stop.
  double speed(double t) const;
  double seconds() const { return seconds_; }  ///< that the integration took

 private:
  std::vector<double> speeds_;
  double seconds_;
};

}  // namespace tandem::engine_linkage
