// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>

#include "prober.hpp"

namespace tandem::identification {

/// The model of a linear subsystem that tells its states: one own step from each of them, and with each change of an input.
/// Its residual is what it leaves of the prober's runs. Nothing where there are none, they are not told, or follow an input at the start.
std::optional<LinearModel> model_by_states(Prober& prober);

}  // namespace tandem::identification
