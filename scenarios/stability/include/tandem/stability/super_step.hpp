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

/// A subsystem that is sampled or keeps its states to itself, of which a linear model stands in the map
/// (identification/identify.hpp).
struct Identified {
  std::string name;
  bool sampled;
  int order;        ///< states of the model
  double residual;  ///< what it leaves of responses
  bool linear;      ///< superposition holds
};

/// One super-step: the shortest time after which all own steps, the communication step of `parallel`, and the periods of
/// what is sampled, end together again; of up to most_steps of the largest. Where there is none, the first after which they end within a
/// thousandth of a step, else that after which they end nearest together.
struct SuperStep {
  double period = 0.0;              ///< T [s]
  std::vector<std::int64_t> steps;  ///< own steps, or instants, of each subsystem in it
  std::vector<double> own_steps;    ///< of each, or the period at which it is sampled [s]
  std::vector<bool> sampled;        ///< of each subsystem
  double apart = 0.0;  ///< by how much their ends lie apart, at most, as a part of a step; 0: they meet
  std::vector<Coordinate> coordinates;
  std::vector<Identified> identified;
  Eigen::MatrixXd map;  ///< z(t + T) = map z(t), beside what does not depend on z
  bool linear =
      false;  ///< superposition at two amplitudes holds to 1e-10; else the map is that about the start

  /// Of differences: how far the spectral radius by ten times larger ones lies.
  double unsettled = 0.0;

  /// By how much a surrogate of an impulse coupling and its slow side lie apart, and at which speed, is carried on as it is: two
  /// multipliers of 1 for each link, which rounding takes apart. So many, with those of numbers that it has no use for.
  int offsets = 0;

  /// Multipliers that the system undivided has within 1e-6 of 1: of a part that nothing holds, how far it is and how fast it
  /// goes. Errors of the map take them apart by their root, and leave their mean.
  int at_rest = 0;

  /// Spectral radius of the map: above 1 what a run carries grows without end. Offsets do not count; of those at rest it is
  /// the mean.
  double radius() const;
  /// What the modulus of an eigenvalue may be above 1 and mean 1.
  double rounding() const;
};

/// The map of one super-step, by the coordinator and the subsystems themselves. Each past sample and each state in
/// turn is made 1, a run of one super-step goes on from there, and what it comes to is a column. Where subsystems
/// are not linear, columns are central differences about the state at the start.
///
/// A subsystem that does not name its states (Subsystem::states) is replaced by a linear model of it, and so is one that is
/// sampled. What stands after the instants at the begin goes to what stands after those at the end.
///
/// Precondition: all subsystems restart. Throws Error(not_supported) that names the one that does not, of which no
/// linear model is found, or that has an event within the super-step, and for differences that do not settle.
SuperStep super_step(const scenario::Scenario& scenario, const Builtins& builtins);
constexpr std::int64_t most_steps = 1000;
constexpr double most_steps_of_all = 1e5;  ///< of the smallest, but for one of the largest

}  // namespace tandem::stability
