// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Dense>
#include <cstdint>
#include <string>
#include <vector>

#include "tandem/scenario/scenario.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::stability {

/// One number of what a coupled run goes by where all its subsystems stand at one time: a state of a subsystem, or
/// what a past sample of an output, or of its derivative, was.
struct Coordinate {
  int subsystem;
  int index;         ///< of the state, or of the value in the sample's row
  int age;           ///< samples back, 0 the newest; -1: a state
  std::string name;  ///< "fast.x1", "fast.x1 2 samples ago"
};

/// One super-step: the shortest time after which all own steps, and the communication step of `parallel`, end
/// together again.
struct SuperStep {
  double period = 0.0;              ///< T [s]
  std::vector<std::int64_t> steps;  ///< own steps of each subsystem in it
  std::vector<Coordinate> coordinates;
  Eigen::MatrixXd map;  ///< z(t + T) = map z(t), beside what does not depend on z
  bool linear =
      false;  ///< superposition at two amplitudes holds to 1e-10; else the map is that about the start
};

/// The map of one super-step, by the coordinator and the subsystems themselves. Each past sample and each state in
/// turn is made 1, a run of one super-step goes on from there, and what it comes to is a column. Where subsystems
/// are not linear, columns are central differences about the state at the start.
///
/// Precondition: all subsystems name their states (SubsystemInfo::states), and restart. Throws Error(not_supported)
/// that names the one that does not, and for steps without a common period of most_steps largest own steps.
SuperStep super_step(const scenario::Scenario& scenario, const Builtins& builtins);
constexpr std::int64_t most_steps = 1000;

/// The largest modulus of the map's eigenvalues: above 1 what a run carries grows without end.
double spectral_radius(const Eigen::MatrixXd& map);

}  // namespace tandem::stability
