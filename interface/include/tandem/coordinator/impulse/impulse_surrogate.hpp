// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "tandem/subsystem.hpp"

namespace tandem {

/// What an impulse coupling goes by. Of p links, A is a matrix of p rows.
struct ImpulseCoupling {
  /// A force on the slow side, and the displacement there that goes with it.
  struct Link {
    std::string force_unit, displacement_unit;
    /// Of the displacement at the start, per second, and likewise without any of these forces. Its first step hears of both
    /// from the slow side, with all inputs of that as they are then.
    double velocity = 0.0, free_acceleration = 0.0;
    std::string velocity_unit = {};
  };
  std::vector<Link> links;
  /// A by rows: the acceleration of a displacement by a force. Of one link it is 1 / effective mass.
  std::vector<double> accelerance;
  /// Where A of the only link is stated: what a force has been found to accelerate at the start. Else 0. A difference of
  /// more than 0.1 % is remarked upon.
  double found = 0.0;
  /// Its rate at the start, per second. Empty: A stays as it is. Else A is an input.
  std::vector<double> accelerance_rate = {};
  std::vector<std::string> accelerance_units = {};  ///< of that input
  /// Likewise the forces of the slow side's own springs and dampers, by displacements and by their rates. Empty: the
  /// surrogate has none.
  std::vector<double> stiffness, damping;
  /// By so much of itself what they accelerate was off where a constant force had pushed the slow side for up to three steps.
  /// More than 0.5 % is remarked upon.
  double spring_error = 0.0;
  bool trapezoidal = false;  ///< the slow side's rule takes the mean of the positions at the ends of its step
  bool tells_velocities = false;  ///< outputs `velocity`
  int degree = 3;                 ///< of the polynomial that continues the force, 1 to 4
  double own_step = 0.0;          ///< h [s]: of the fast side
  double slow_step = 0.0;         ///< H [s], h or more
  double fast_period = 0.0;       ///< T_f [s]: the shortest of the coupled system
};

/// Stands for a slow side beside the fast one. It carries that side's reaction to the fast force within its step, and gives it
/// the mean force that keeps its error bounded at any frequency. It leads with the fast side's step.
///
/// The double integral of A F is the slow side's motion but for a smooth rest, which is a parabola that follows
/// from its last two steps. What the slow side comes to beyond that (the defect) is put in while the next step lasts.
///
/// Inputs: of each link `force`, then of each `position`, the slow side's displacement, in a signal that has its value
/// and two derivatives at the slow side's last node. Then, where A varies, `accelerance` with its rate there.
///
/// Outputs:
/// - of each link `displacement` with its rate;
/// - of each `mean_force`, for the step of the slow side whose end it has reached;
/// - if they are wanted, of each `velocity`, the rate of the displacement, with its own;
/// - unless A varies, of each `reaction_error` (ReactionCheck); one above 0.1 % is remarked upon.
///
/// With several links names have numbers: "force_1", and "accelerance_1_2" for what force 2 accelerates at link 1.
///
/// Throws Error(invalid_argument) for steps and a period that are not finite and above 0, a slow step that is no longer
/// than the fast one, a degree beyond 1 to 4, and matrices of another size. Its step throws
/// Error(not_supported) where the slow side does not stand where it is to stand, Error(numerical) for an A that is not above
/// 0 on its diagonal.
std::unique_ptr<Subsystem> impulse_surrogate(ImpulseCoupling coupling);

}  // namespace tandem
