// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "tandem/mbs/sparse/linear_solver.hpp"

namespace tandem::mbs::solvers {

std::unique_ptr<LinearSolver> automatic(MatrixKind kind);
std::unique_ptr<LinearSolver> eigen_dense(MatrixKind kind);
std::unique_ptr<LinearSolver> prepared(MatrixKind kind);
std::unique_ptr<LinearSolver> band(MatrixKind kind);

struct SolverEntry {
  std::string name;
  MatrixKind worst;  ///< that it takes
  MakeSolver* make;
};
/// Those that libraries have (mbs/libraries). A program of its own, as an FMU is, may be made without: it says
/// that there are none.
std::vector<SolverEntry> library_solvers();

}  // namespace tandem::mbs::solvers
