// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>
#include <string>
#include <vector>

#include "tandem/mbs/model.hpp"

namespace tandem::mbs {

/// Coordinates that leave all others to the constraints, about where a model stands, and their rates.
///
/// Of the motions that the constraints leave, each coordinate has a part. A QR decomposition with column pivoting
/// takes those coordinates whose parts tell the motions apart best (J. Garcia de Jalon, E. Bayo, 1994, ch. 5, by
/// Gaussian elimination there). Of a state of first order (Structure::states) there is the rate alone.
class Independent {
 public:
  /// `model` must outlive it; it is looked at where `at` stands.
  Independent(Model& model, const State& at);

  /// "P.x", "theta", then "P.x_rate", "theta_rate"; of a state its name alone.
  const std::vector<std::string>& names() const { return names_; }
  /// x: one number for each name.
  void get(const State& from, std::span<double> x) const;
  /// Positions and velocities with these numbers, the others by consistent_state() from `near`, which also tells
  /// the time.
  State put(State near, std::span<const double> x) const;

 private:
  Model& model_;
  std::vector<int> positions_, rates_;  ///< coordinates
  std::vector<std::string> names_;
};

}  // namespace tandem::mbs
