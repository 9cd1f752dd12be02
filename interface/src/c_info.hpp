// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/subsystem.h"
#include "tandem/subsystem.hpp"

namespace tandem {

/// What a C subsystem says of itself, `c`, with a flag by output that is 1 where it is held (null: none is),
/// and the nominal value of each (null: 1). Throws Error for null, for lists that are not there, and for
/// flags other than 0 and 1.
SubsystemInfo info_from(const tandem_info* c, const std::int32_t* held, const double* nominal);

}  // namespace tandem
