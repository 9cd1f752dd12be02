// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "scenes.hpp"

namespace tandem::study {

/// A note that rows have to run one at a time, as a subsystem of the first row of a table may be in a process once; empty:
/// they need not.
std::string one_at_a_time(const Study& study, Scenes& scenes, const Builtins& builtins);

}  // namespace tandem::study
