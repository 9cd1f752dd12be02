// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/transports/open.hpp"

namespace tandem::diagrams {

/// "diagram:FILE": a diagram's file as a subsystem. Parameters: `step` [s], `integrator`, the settings of the
/// one that is chosen by the names of IntegratorSettings and AdaptiveSettings, and the diagram's own
/// parameters. What is not given is taken from the file's table [run], else by default; `step` must be given.
void add_sources(Builtins& builtins);

}  // namespace tandem::diagrams
