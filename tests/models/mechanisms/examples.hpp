// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "tandem/mbs/mechanism/mechanism.hpp"

namespace tandem::mechanisms {

/// A mechanism of scenarios/mechanisms with the truth that it is judged by.
struct Example {
  std::string name;  ///< also of its folder and its file
  double end;        ///< [s]
  int steps;         ///< of a run that is neither coarse nor fine
  /// The judged quantities' distance from the truth at state.time (Euclidean, [m] or [rad]).
  std::function<double(const mbs::Mechanism&, const mbs::State&)> error;
};

const std::vector<Example>& examples();

}  // namespace tandem::mechanisms
