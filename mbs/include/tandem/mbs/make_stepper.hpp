// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "tandem/mbs/formulations/index1.hpp"
#include "tandem/mbs/formulations/index3.hpp"
#include "tandem/mbs/formulations/null_space.hpp"
#include "tandem/mbs/formulations/penalty.hpp"
#include "tandem/mbs/integrators/newmark.hpp"
#include "tandem/mbs/stepper.hpp"

namespace tandem::mbs {

/// Which formulation, which integrator, and the settings of each. Those of a formulation or integrator that
/// is not chosen must be as they are here.
struct StepperSettings {
  std::string formulation = "index3";  ///< index3, penalty, index1, null_space
  std::string integrator = "newmark";  ///< or rk2, rk4, rk8, generalized_alpha; index3 has newmark merged in
  Index3Settings index3{};             ///< beta and the tolerance of newmark with it stand here
  PenaltySettings penalty{};
  Index1Settings index1{};
  NullSpaceSettings null_space{};
  NewmarkSettings newmark{};
  GeneralizedAlphaSettings generalized_alpha{};
};

/// A formulation and an integrator that go together.
struct StepperNames {
  std::string formulation, integrator;
};
/// All of them.
std::vector<StepperNames> stepper_names();

/// `model` must outlive it. Throws Error for names that are not there or don't go together, and for settings
/// that are not allowed or not used, with what is allowed.
std::unique_ptr<Stepper> make_stepper(Model& model, const StepperSettings& settings);

}  // namespace tandem::mbs
