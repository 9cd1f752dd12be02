// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tandem::output {

/// Of this process and of those that it has started, and these, that still run: all threads [s]. The
/// difference of two is what was spent between them, if none of them ended meanwhile. Where the system does
/// not tell of other processes (elsewhere than on Linux), of this one.
double processor_time();

}  // namespace tandem::output
