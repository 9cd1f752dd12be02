// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "tandem/transports/parameters.hpp"
#include "two_mass/model.hpp"

namespace tandem::test {

/// The parameters of the example mass2 that make it builtin:two_mass.slow at that frequency ratio.
inline std::string mass2_parameters(double frequency_ratio = 30.0, double t_start = 0.0) {
  const two_mass::Model model({.frequency_ratio = frequency_ratio});
  const two_mass::Motion start = model.exact(t_start);
  Parameters p;
  p.set("m", model.m2);
  p.set("k", model.k2);
  p.set("s", model.k2 + model.k3);
  p.set("x", start.x2);
  p.set("v", start.v2);
  p.set("h", model.h2);
  return p.rest();
}

}  // namespace tandem::test
