// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tandem::cli {

/// Under a limit of its addresses or data (`ulimit -v`, `-d`) the program is begun anew with OPENBLAS_NUM_THREADS=1,
/// whatever number the environment has. OpenBLAS makes threads as it is loaded, before main(); one that finds no
/// memory tries for ever, and the program's end waits for it. (tandem uses one.) Does nothing where that is
/// not known.
void begin_anew_if_limited(char** argv);

}  // namespace tandem::cli
