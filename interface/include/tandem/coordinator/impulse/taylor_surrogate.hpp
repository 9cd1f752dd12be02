// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "tandem/slow_model.hpp"
#include "tandem/subsystem.hpp"

namespace tandem {

/// What a Taylor surrogate goes by.
struct TaylorCoupling {
  struct Link {
    std::string force_unit, displacement_unit, velocity_unit = {};
  };
  std::vector<Link> links;
  std::shared_ptr<SlowModel> model;
  std::vector<double> velocities;  ///< of the slow side's coordinates at the start
  bool tells_velocities = false;   ///< outputs `velocity`
  int degree = 4;                  ///< of the polynomial that continues the force, 1 to 4
  double own_step = 0.0;           ///< h [s]: of the fast side
  double slow_step = 0.0;          ///< H [s], longer
  double fast_period = 0.0;        ///< T_f [s]: the shortest of the coupled system
};

/// Stands for a slow side beside the fast one, with all its coordinates. Their equations are a Taylor polynomial of second
/// order in coordinates and velocities about the slow side's last node. So the reaction is that of the whole of it: also of
/// modes that the slow steps do not resolve, and of a mass that varies with the ripple. It leads with the fast side's step.
///
/// The slow side gets the mean force, and on all its coordinates what brings it to where the mean acceleration of the
/// surrogate does. What it comes to beyond that (the defect) is put in while the next step lasts. What the polynomial lacks
/// goes on with the cube of the time since the node.
///
/// Inputs: of each link `force`; then `coordinates`, n numbers in a signal that has their values and rates at the slow
/// side's last node.
///
/// Outputs:
/// - of each link `displacement` with its rate;
/// - of each `mean_force`, for the step of the slow side whose end it has reached;
/// - n numbers `reaction`, generalised forces for that step;
/// - if they are wanted, of each link `velocity`, the rate of the displacement, with its own.
///
/// With several links names have numbers: "force_1".
///
/// Throws Error(invalid_argument) for:
/// - steps and a period that are not finite and above 0, and a slow step that is no longer than the fast one;
/// - a degree beyond 1 to 4, and other links or velocities than the model has.
///
/// Its step throws Error(not_supported) where the slow side does not stand where it is to stand.
std::unique_ptr<Subsystem> taylor_surrogate(TaylorCoupling coupling);

}  // namespace tandem
