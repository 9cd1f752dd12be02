// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tandem/mbs/make_stepper.hpp"
#include "tandem/mbs/mechanism/description.hpp"
#include "tandem/mbs/mechanism/limits.hpp"
#include "tandem/mbs/step_matrices.hpp"
#include "tandem/subsystem.hpp"

namespace tandem::mbs {

/// Matrices to be written while a mechanism runs (step_matrices.hpp).
struct MatrixDump {
  std::filesystem::path folder = {};  ///< none: nothing is written
  /// [s], ascending: each where the first own step ends that gets there, or at the start.
  std::vector<double> times = {};
  MatrixFormat format = MatrixFormat::matrix_market;
};

struct SubsystemSettings {
  double step = 0.0;  ///< own step [s]
  StepperSettings stepper = {};
  MatrixDump dump = {};
  TellOfLimit tell = {};  ///< takes what limits of the description tell; null: nobody
};

/// A mechanism that integrates itself with a fixed own step. Inputs are those of the description that have no
/// function of time (a force, a torque, a prescribed motion, of which the signal's derivatives are used too);
/// outputs are the description's. Positions come with their first two derivatives by time, velocities with
/// their first. A position or velocity does not follow a force at once, an acceleration or reaction does; a
/// prescribed motion is followed by all. Inputs are read at the end of each own step, and at its beginning.
/// Where they differ there from what they were at the end of the step before, accelerations and multipliers
/// are computed anew first (a held input would ruin the trapezoidal rule otherwise). A step may be cut
/// (lands). Limits are looked at where a run begins and at the end of each own step. It remarks constraints
/// that say nothing beside the others where it stands (freedom.hpp), and data that end before the run does.
/// Throws Error for a step that is not finite and above 0, and for what Mechanism and make_stepper() refuse.
std::unique_ptr<Subsystem> make_subsystem(Description description, const SubsystemSettings& settings);

/// Gives independent coordinates that all others follow an output "coordinate.NAME" and an input "reaction.NAME", a
/// generalised force on each, where that can be: those of these outputs first, which are positions, then relative ones. The
/// subsystem has a slow_model() then, of links that are forces and these displacements. Elements with states can't.
void take_reactions(Description& description, const std::vector<std::string>& displacements);

/// A model that is no mechanism, and how it begins.
struct NamedModel {
  std::string name;
  std::shared_ptr<Model> model;
  State start;                     ///< its time is put by initialize()
  std::vector<std::string> units;  ///< of the variables
};

/// The same of any model. It has no inputs; its outputs are the variables, NAME, with two derivatives, their
/// rates, NAME_rate, with one, and the energy if the model gives one. Throws Error as above, and for
/// settings.dump, which is for mechanisms.
std::unique_ptr<Subsystem> make_subsystem(NamedModel model, const SubsystemSettings& settings);

}  // namespace tandem::mbs
