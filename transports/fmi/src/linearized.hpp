// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>

#include "instance.hpp"
#include "tandem/linearized.hpp"

namespace tandem::fmi {

/// By directional derivatives of an FMU of Model Exchange (FMI 2.0, chapter 2.1.9; FMI 3.0, chapter 2.2.11),
/// where it stands. Nothing: it gives none, or has ports that are no real numbers.
std::optional<Linearized> linearized(Instance& fmu);

}  // namespace tandem::fmi
