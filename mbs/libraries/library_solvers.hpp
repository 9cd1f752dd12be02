// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/solvers.hpp"

namespace tandem::mbs::solvers {

std::unique_ptr<LinearSolver> klu(MatrixKind kind);
std::unique_ptr<LinearSolver> klu_full(MatrixKind kind);
std::unique_ptr<LinearSolver> lapack(MatrixKind kind);
std::unique_ptr<LinearSolver> lapack_lu(MatrixKind kind);
std::unique_ptr<LinearSolver> lapack_band(MatrixKind kind);

}  // namespace tandem::mbs::solvers
