// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "tandem/scenario/scenario.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::study {

/// Lines of a table `set` that make those own steps `factor` times as long of which a parameter is known to make them.
std::string known_steps(const scenario::Scenario& scenario, const Builtins& builtins, double factor);

}  // namespace tandem::study
