// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "tandem/mbs/sparse/linear_solver.hpp"

namespace tandem::test {

/// Adds to those of mbs::make_solver() the linear solvers of F. Gonzalez, doctoral thesis, A Coruna 2010, chapter
/// 3, that are worth no place among them: cholmod, cholmod_supernodal, umfpack, superlu, mumps, ldlt, as far
/// as their libraries are there. A second call does nothing.
bool add_thesis_solvers();

// One of each.
std::unique_ptr<mbs::LinearSolver> cholmod(mbs::MatrixKind kind);
std::unique_ptr<mbs::LinearSolver> cholmod_supernodal(mbs::MatrixKind kind);
std::unique_ptr<mbs::LinearSolver> umfpack(mbs::MatrixKind kind);
std::unique_ptr<mbs::LinearSolver> superlu(mbs::MatrixKind kind);
std::unique_ptr<mbs::LinearSolver> mumps(mbs::MatrixKind kind);
std::unique_ptr<mbs::LinearSolver> ldlt(mbs::MatrixKind kind);

}  // namespace tandem::test
