// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tandem/engine/integrators/integrator.hpp"

namespace tandem::engine {

/// Tolerances and limits of the integrators of SUNDIALS.
struct AdaptiveSettings {
  double relative_tolerance = 1e-6, absolute_tolerance = 1e-9;  ///< Of each state.
  std::map<std::string, double> absolute_tolerances = {};       ///< Of states by name, instead of that.
  double longest_step = 0.0;                                    ///< [s]; 0: no limit.
  double shortest_step = 0.0;                                   ///< [s]; a shorter one is an error.
  long most_steps = 1'000'000;  ///< Within one step that the caller asks for; then it is an error.

  bool operator==(const AdaptiveSettings&) const = default;
};

// The integrators of SUNDIALS (A. Hindmarsh et al., ACM Trans. Math. Softw. 31 (2005) 363; D. Reynolds et
// al., ibid. 49 (2023) 19). They locate changes of sign by their own root finding on their interpolant, and
// stop at the time that they are asked for. Their messages become Error(numerical) with the time.
// - cvode_adams, cvode_bdf: CVODE, linear multistep methods of variable order, Adams for non-stiff problems
//   with a fixed-point iteration, BDF for stiff ones with Newton's method and a dense Jacobian by
//   differences.
// - erkstep: ARKODE's ERKStep, the explicit Runge-Kutta pair of order 4 that it takes by default.
// - erkstep_fixed: the same with steps as long as the caller asks for, without error control; the settings
//   must be as they are by default. Events are located on its interpolant of order 3.
// - arkstep: ARKODE's ARKStep with the diagonally implicit pair of order 4 that it takes by default, and
//   Newton's method.
std::vector<std::string> adaptive_names();
/// One of them by its name; null: there is none of that name. Throws Error(invalid_argument) for a setting
/// that is not allowed.
std::unique_ptr<AdaptiveIntegrator> adaptive_integrator(const std::string& name,
                                                        const AdaptiveSettings& settings);
/// The same, of diagrams.
std::unique_ptr<Integrator> adaptive_integrator_of_diagrams(const std::string& name,
                                                            const AdaptiveSettings& settings);
/// Refuses settings for an integrator that has none.
void refuse_settings(const std::string& name, const AdaptiveSettings& settings);

}  // namespace tandem::engine
