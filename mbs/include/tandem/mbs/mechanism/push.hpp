// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/mbs/mechanism/mechanism.hpp"

namespace tandem::mbs {

/// The generalised forces on the variables of an input of 1, which only forces follow, at positions q of all coordinates.
Eigen::VectorXd push_of(const Mechanism& mechanism, int input, const Eigen::VectorXd& q);

}  // namespace tandem::mbs
