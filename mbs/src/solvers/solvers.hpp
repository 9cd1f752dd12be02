// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "tandem/mbs/sparse/linear_solver.hpp"

namespace tandem::mbs::solvers {

std::unique_ptr<LinearSolver> automatic(MatrixKind kind);
std::unique_ptr<LinearSolver> klu(MatrixKind kind);
std::unique_ptr<LinearSolver> klu_full(MatrixKind kind);
std::unique_ptr<LinearSolver> lapack(MatrixKind kind);
std::unique_ptr<LinearSolver> lapack_lu(MatrixKind kind);
std::unique_ptr<LinearSolver> lapack_band(MatrixKind kind);
std::unique_ptr<LinearSolver> eigen_dense(MatrixKind kind);
std::unique_ptr<LinearSolver> prepared(MatrixKind kind);
std::unique_ptr<LinearSolver> band(MatrixKind kind);

}  // namespace tandem::mbs::solvers
