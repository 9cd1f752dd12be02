// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "fmu.hpp"

namespace tandem::fmi {

/// The library for this platform, and what can be seen of it without loading it: that it is absent, is none
/// for this processor, or lacks the functions by which an FMU is made and moved.
std::string library_sentence(const Fmu& fmu);

}  // namespace tandem::fmi
