// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/mbs/model.hpp"

namespace tandem::mbs {

/// The checks of formulations throw Error(numerical) with names and the time.

/// What |Phi| of each constraint may be.
std::vector<double> most_off(const Structure& structure);
struct Constraints {
  const double *phi, *most, *jacobian;
};
/// A constraint whose row of the Jacobian vanishes: it is below 1e-12 of the largest row; or one with |Phi|
/// above `most`.
void refuse_lost_constraint(const Model& model, const State& state, const Constraints& at);
/// The first variable at which the forces are not finite.
void refuse_wrong_force(const Structure& structure, const Eigen::VectorXd& force, double time);
/// The matrix named is singular at a variable, or not positive definite; its constraints are named too.
[[noreturn]] void refuse_singular(const Structure& structure, const char* matrix, int variable, double time);
/// Newton's or another iteration has not ended.
[[noreturn]] void refuse_unsettled(int iterations, double time);

}  // namespace tandem::mbs
