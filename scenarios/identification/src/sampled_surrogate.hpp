// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "tandem/identification/linear_model.hpp"
#include "tandem/subsystem.hpp"

namespace tandem::identification {

/// make_surrogate() of a sampled subsystem.
std::unique_ptr<Subsystem> make_sampled_surrogate(LinearModel model, const SubsystemInfo& of);

}  // namespace tandem::identification
