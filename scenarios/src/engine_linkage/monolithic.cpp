// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "engine_linkage/monolithic.hpp"

#include <numbers>

namespace tandem::engine_linkage {

engine::Description monolithic(engine::Description d, int loops) {
  using Wires = std::vector<engine::Wire>;
  const double inertia = (4.0 * loops + 1.0) / 3.0 + 14.0, weight = 9.81 * (3.0 * loops + 1.0) / 2.0;
  d.inputs.clear();
  d.blocks.push_back({"phi_rate", "gain", {{"input", "speed"}, {"gain", -1.0}}});
  d.blocks.push_back({"phi", "integrator", {{"input", "phi_rate"}, {"initial", std::numbers::pi / 2.0}}});
  d.blocks.push_back({"lean", "function", {{"input", "phi"}, {"function", "cos"}}});
  d.blocks.push_back({"acceleration",
                      "sum",
                      {{"inputs", Wires{"torque", "speed", "lean"}},
                       {"gains", Wires{1.0 / inertia, -3.18 / inertia, weight / inertia}}}});
  d.blocks.push_back({"speed", "integrator", {{"input", "acceleration"}, {"initial", 30.0}}});
  d.outputs.push_back({"speed", "rad/s", "speed"});
  return d;
}

}  // namespace tandem::engine_linkage
