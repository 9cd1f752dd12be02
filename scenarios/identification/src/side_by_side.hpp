// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <span>

#include "tandem/subsystem.hpp"
#include "tandem/time_grid.hpp"

namespace tandem::identification {

/// Runs both from the start to the end of a run with inputs that stay as they are. When a value differs most, if that is by
/// more than a part of its largest magnitude; else nothing.
std::optional<double> apart(Subsystem& real, Subsystem& model, const TimeSpan& span,
                            std::span<const double> u0, double part);

}  // namespace tandem::identification
