// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "mechanisms/examples.hpp"
#include "tandem/mbs/make_stepper.hpp"

namespace tandem::mechanisms {

/// One formulation and integrator on one mechanism, with that many steps and with twice as many.
struct FormulationCase {
  const Example* example;
  mbs::StepperNames names;
  int steps;
};
/// Every pair on every example, at its own number of steps.
std::vector<FormulationCase> formulation_cases();

/// A row of results/mbs/formulations.csv and one of errors.csv. order: log2 of the ratio of the two runs'
/// distances from the truth at the end; energy_drift: by then, as a part of the largest kinetic energy, the
/// work of constant forces taken off; residuals: largest in the last state; all of the finer run. status: ok;
/// no order, where that is 0.5 and more below the integrator's; failed. error: the finer run's distance from
/// the truth [m or rad]; note: the sentence of what failed.
struct FormulationRow {
  std::string figures, error;
};
inline constexpr const char* formulations_header =
    "mechanism,formulation,integrator,step,order,energy_drift,position_residual,velocity_residual,"
    "acceleration_residual,status";
inline constexpr const char* errors_header = "mechanism,formulation,integrator,step,error,note";
/// mechanisms: the folder that has the examples' folders.
FormulationRow formulation_row(const FormulationCase& c, const std::filesystem::path& mechanisms);

/// Every pair on every example with a quarter, half, once and twice its number of steps.
std::vector<FormulationCase> work_cases();
/// A row of results/mbs/work.csv: error as above; seconds: processor time of the steps, the least of several
/// runs. It is that of the process, so one row is made at a time.
inline constexpr const char* work_header = "mechanism,formulation,integrator,step,error,seconds,status";
std::string work_row(const FormulationCase& c, const std::filesystem::path& mechanisms);

}  // namespace tandem::mechanisms
