// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "tandem/mbs/sparse/linear_solver.hpp"

namespace tandem::mbs::solvers {

std::unique_ptr<LinearSolver> klu(MatrixKind kind);
std::unique_ptr<LinearSolver> ldlt(MatrixKind kind);
std::unique_ptr<LinearSolver> prepared(MatrixKind kind);
std::unique_ptr<LinearSolver> band(MatrixKind kind);

}  // namespace tandem::mbs::solvers
