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

inline std::vector<ContractCase> diagram_cases() {
  std::vector<ContractCase> all;
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
