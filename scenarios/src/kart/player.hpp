// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <vector>

#include "tandem/subsystem.hpp"

namespace tandem::kart {

/// Plays a torque [N m] that is recorded every `step` s from the start on; its output is `torque`. A run
/// beyond the record is Error(invalid_argument).
std::unique_ptr<Subsystem> make_player(std::vector<double> torque, double step);

}  // namespace tandem::kart
