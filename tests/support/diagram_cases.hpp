// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Diagrams as subsystems: the contract.
#pragma once
#include <string>
#include <vector>

#include "contract_suite.hpp"
#include "pushed_mass.hpp"
#include "tandem/engine/read.hpp"
#include "tandem/engine/subsystem.hpp"

namespace tandem::test {

/// A ramp that begins anew, samples of it and of an input, a switch: outputs that are held, that jump and
/// that do neither.
inline const std::string switching =
    "[inputs]\nu = { unit = '1' }\n[blocks]\n"
    "rate = { kind = 'gain', input = 'u', gain = 0.1, offset = 20 }\n"
    "past = { kind = 'gain', input = 'ramp', gain = 1, offset = -1 }\n"
    "ramp = { kind = 'integrator', input = 'rate', reset = 'past' }\n"
    "held = { kind = 'sample', input = 'ramp', period = 0.017 }\n"
    "more = { kind = 'switch', control = 'ramp', threshold = 0.5, above = 'u', below = 'held' }\n"
    "lag = { kind = 'lag', input = 'more', time = 0.05 }\n[outputs]\n"
    "ramp = { unit = '1' }\nheld = { unit = '1' }\nmore = { unit = '1' }\nlag = { unit = '1' }\n";

/// Two blocks that sample with periods of their own.
inline const std::string sampled =
    "[inputs]\nu = { unit = '1' }\nw = { unit = '1' }\n[blocks]\n"
    "fast = { kind = 'sample', input = 'limited', period = 0.006, offset = 0.001 }\n"
    "limited = { kind = 'saturation', input = 'u', low = -0.5, high = 0.5 }\n"
    "next = { kind = 'sum', inputs = ['sum', 'fast', 'w'] }\n"
    "sum = { kind = 'sample', input = 'next', period = 0.009 }\n[outputs]\n"
    "fast = { unit = '1' }\nsum = { unit = '1' }\n";

inline std::vector<ContractCase> diagram_cases() {
  std::vector<ContractCase> all;
  const auto add = [&](const std::string& name, const std::string& text, double step, double t_start) {
    all.push_back({name,
                   [=] { return engine::make_subsystem(engine::read_diagram(name, text), {.step = step}); },
                   t_start});
  };
  add("switching", switching, 0.01, 0.0);
  add("switching_late", switching, 0.013, -7.3);
  add("sampled", sampled, 0.0, 0.0);
  add("sampled_late", sampled, 0.0, 11.3);
  for (const std::string& integrator : engine::integrator_names())
    for (const double t_start : {0.0, -7.3})
      all.push_back({"pushed_mass_" + integrator + (t_start < 0.0 ? "_late" : ""),
                     [integrator] {
                       return engine::make_subsystem(engine::read_diagram("pushed_mass", pushed_mass),
                                                     {0.01, {.name = integrator}, {}});
                     },
                     t_start});
  return all;
}

}  // namespace tandem::test
