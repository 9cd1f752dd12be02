// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "instance.hpp"

namespace tandem::fmi {

/// First time derivatives of outputs that no variable has, and for which the FMU has a function
/// (fmi2GetRealOutputDerivatives, fmi3GetOutputDerivatives).
class DerivedOutputs {
 public:
  DerivedOutputs(const Description& description, const std::vector<Seat>& seats);

  /// After the start, each alone: Error(numerical) that names an output whose derivative the FMU refuses, or
  /// says is no number. Its largest order is that of some outputs only.
  void try_each(Instance& fmu);
  /// values[place] of each becomes its derivative; one call.
  void get(Instance& fmu, double* values);

 private:
  std::vector<Seat> seats_;
  std::vector<std::uint32_t> references_;
  std::vector<int> orders_;
  std::vector<double> values_;  ///< of all, one output after the other
};

}  // namespace tandem::fmi
