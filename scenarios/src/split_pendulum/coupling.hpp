// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "tandem/coordinator/coordinator.hpp"

namespace tandem::split_pendulum {

/// A mechanism that integrates itself with Newmark's method.
struct Side {
  std::string name, text;
  double step;  ///< [s]
};

/// Mechanisms and what connects them.
struct Coupling {
  std::vector<Side> sides;
  std::vector<Connection> connections;
  std::string formulation, schedule;
  double t_stop;  ///< [s]
};

/// Runs it from 0 s; `observer` may end it. Returns why it went no further, nothing if it ended. Throws Error
/// for what is not numerical: a scheme that can't be honoured.
std::string run(const Coupling& coupling, Observer& observer);

}  // namespace tandem::split_pendulum
