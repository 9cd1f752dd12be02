// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tandem::fmi {

/// What an FMU says after it has updated its discrete states.
struct Updated {
  bool again, ended;
  double next_event;  ///< [s]; infinite if none is known
};
/// What an FMU says after a step of who integrates it.
struct Completed {
  bool event, ended;
};
/// What has come of a step of Co-Simulation.
struct Taken {
  double time;  ///< to which it has come [s]
  bool event, ended;
};

/// Sets inputs within a step of Co-Simulation, at the times at which the FMU asks for them.
class InputsWithin {
 public:
  virtual void set(double t) = 0;

 protected:
  ~InputsWithin() = default;
};

}  // namespace tandem::fmi
