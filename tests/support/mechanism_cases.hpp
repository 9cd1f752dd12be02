// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Mechanisms as subsystems: the contract, with every formulation and integrator.
#pragma once
#include <string>
#include <vector>

#include "contract_suite.hpp"
#include "pushed_pendulum.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "tandem/mbs/subsystem.hpp"

namespace tandem::test {
inline const std::string driven =
    "dimension = 2\ngravity = [0, -9.81]\n[points]\nA = { at = [1, 0] }\nB = { at = [1, -1] }\n"
    "[rods]\nr = { points = ['A', 'B'], mass = 1 }\n[inputs]\nx = { unit = 'm', value = 1 }\ny = { unit = "
    "'m', value = 0 }\n"
    "[drives]\nx = { coordinate = 'A.x', motion = 'x' }\ny = { coordinate = 'A.y', motion = 'y' }\n"
    "[outputs]\nB = { position = 'B.x' }\nR = { reaction = 'x' }\n";

inline ContractCase mechanism(const std::string& name, const std::string& text,
                              const mbs::StepperSettings& stepper, double t_start = 0.0) {
  return {name + "_" + stepper.formulation + "_" + stepper.integrator,
          [=] {
            return mbs::make_subsystem(mbs::read_mechanism(name, text), {0.01, stepper});
          },
          t_start};
}

inline std::vector<ContractCase> mechanism_cases() {
  std::vector<ContractCase> all;
  for (const auto& [formulation, integrator] : mbs::stepper_names())
    all.push_back(mechanism("pushed", pushed_pendulum, {formulation, integrator}));
  mbs::StepperSettings with_pivots;
  with_pivots.index3.solver = "klu";
  all.push_back(mechanism("pivots", driven, with_pivots));
  all.push_back(mechanism("driven", driven, {}));
  all.push_back(mechanism("late", pushed_pendulum, {}, -7.3));
  return all;
}

}  // namespace tandem::test
