// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <string>
#include <vector>

#include "tandem/coordinator/history.hpp"

namespace tandem::kart {

/// A quantity of a run over time: the side that has it (0 kart, 1 engine), the names that the levels give
/// this output, and the factor from its unit there. In space it is that of the left wheel.
struct Traced {
  const char* name;
  int side;
  std::array<const char*, 2> outputs;
  double factor = 1.0;
};
inline constexpr double degrees = 57.29577951308232;
inline constexpr Traced traced[] = {{"throttle", 1, {"throttle", ""}},
                                    {"gear", 1, {"gear", ""}},
                                    {"torque", 1, {"torque", ""}},
                                    {"pitch", 0, {"pitch", ""}, degrees},
                                    {"speed", 0, {"speed", ""}},
                                    {"front_load", 0, {"front_load", "load_FL"}},
                                    {"rear_load", 0, {"rear_load", "load_RL"}},
                                    {"front_slip", 0, {"front_slip", "slip_FL"}},
                                    {"rear_slip", 0, {"rear_slip", "slip_RL"}}};

/// What `traced` names at the multiples of 10 ms, of a side whose own steps meet them.
class Trace {
 public:
  static constexpr double step = 1e-2;  ///< [s]
  Trace() = default;
  Trace(const SubsystemInfo& kart, const SubsystemInfo& engine);

  /// Keeps the row of a side's history if it is one of these instants.
  void add(int side, const History& history, std::int64_t row);

  /// Values of the k-th; empty if neither side has it.
  const std::vector<double>& operator[](std::size_t k) const { return values_[k]; }

 private:
  static constexpr std::size_t size = std::size(traced);
  std::array<int, size> columns_ = {};  ///< -1: none
  std::array<std::vector<double>, size> values_;
};

}  // namespace tandem::kart
