// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "tandem/study/ranks.hpp"

namespace tandem::cli {

/// The ranks of the MPI program that this process is one of, or null: it was not started by mpirun, srun or the
/// like. They end with it. Throws Error in a build without MPI, and for one rank alone returns null.
std::unique_ptr<study::Ranks> mpi_ranks();

}  // namespace tandem::cli
