// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "fmu.hpp"

namespace tandem::fmi {

/// Why the library for this platform can't be run, as far as is seen without loading it: it is absent, is none for this
/// processor, or lacks the functions by which an FMU is made and moved. Empty: nothing is seen against it.
std::string library_obstacle(const Fmu& fmu);

}  // namespace tandem::fmi
