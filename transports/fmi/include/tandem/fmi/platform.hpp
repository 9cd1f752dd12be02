// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "tandem/fmi/description.hpp"

namespace tandem::fmi {

/// The folder of an FMU's libraries for this platform: "binaries/linux64/"; empty: that version of the
/// standard names none.
std::string binaries_of_this_platform(Version version);

}  // namespace tandem::fmi
