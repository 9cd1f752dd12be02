// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/mbs/formulations/terms.hpp"

namespace tandem::mbs {

/// The highest frequency [rad/s] of the motion that the constraints leave, at a complete state: its square is
/// the spectral radius of T^-1 (K + d(Phi_q^T lambda)/dq), where T = M + penalty Phi_q^T Phi_q takes
/// constrained directions away. The penalty's own frequencies, sqrt(penalty) times the singular values of
/// Phi_q, are not among them: the merged formulation satisfies Phi = 0, whatever the penalty. Factorizes T
/// once.
double merged_frequency(Terms& terms, const State& s, double penalty);

}  // namespace tandem::mbs
