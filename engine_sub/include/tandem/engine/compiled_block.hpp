// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>
#include <string>
#include <vector>

namespace tandem::engine {

/// A kind of block written in C++: y = output(p, x, u), x' = rates(p, x, u), for parameters p, states x and
/// inputs u in the order of their names here. Both are called wherever an integrator evaluates, so they keep
/// nothing between calls and do not throw; a number that is not finite ends the run with the block's name.
/// A diagram uses it like any other kind: its inputs are ports, its parameters and states are keys (of a
/// state: its value at the start, a number or a signal). The names kind and unit are taken.
struct CompiledBlock {
  using Function = void (*)(const double* p, const double* x, const double* u, double* result);
  struct Quantity {
    std::string name;
    double otherwise = std::numeric_limits<double>::quiet_NaN();  ///< if it is not given; NaN: it must be
  };

  std::string kind;
  std::vector<std::string> inputs, outputs;
  std::vector<Quantity> parameters = {}, states = {};
  Function output = nullptr;  ///< writes one number for each output
  Function rates = nullptr;   ///< writes one for each state; null where there is none
  bool feedthrough = true;    ///< outputs depend on inputs at once; if not, u is null in output()
};

}  // namespace tandem::engine
