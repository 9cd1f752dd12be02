// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/mbs/mechanism/limits.hpp"
#include "tandem/transports/open.hpp"

namespace tandem::mechanisms {

/// "mechanism:FILE": a mechanism's file as a subsystem. Parameters: `step` [s]; `formulation` and
/// `integrator` by name, and the settings of the two that are chosen, by the names of StepperSettings;
/// `animate`, which adds an output for each coordinate of each point and of vectors that move (`tandem view`
/// draws them); `matrices`, a folder for those of steps, `matrices_at` (times [s] with commas between; by
/// default the start) and `matrices_format` (mtx, ccs). What is not given is taken from the file's table
/// [run], else by default; `step` must be given. `tell` takes what the limits of a file tell.
void add_sources(Builtins& builtins, const mbs::TellOfLimit& tell = {});

/// The same sources; their mechanisms write no matrices, whatever is said.
Builtins without_matrices(Builtins builtins);

}  // namespace tandem::mechanisms
