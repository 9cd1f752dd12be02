// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "loop_solver.hpp"

#include <fmt/format.h>
#include <kinsol/kinsol.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tandem/error.hpp"

namespace tandem::engine {

LoopSolver::LoopSolver(const Program& program, const Loop& loop)
    : program_(program), loop_(loop), size_(static_cast<int>(loop.cuts.size())) {
  SUNContext_Create(nullptr, &context_);
  for (N_Vector* vector : {&v_, &f_, &scale_}) *vector = N_VNew_Serial(size_, context_);
  matrix_ = SUNDenseMatrix(size_, size_, context_);
  solver_ = SUNLinSol_Dense(v_, matrix_, context_);
  create();
}

void LoopSolver::create() {
  memory_ = KINCreate(context_);
  KINSetErrHandlerFn(memory_, take_message, this);
  KINInit(memory_, residual, v_);
  KINSetUserData(memory_, this);
  KINSetLinearSolver(memory_, solver_, matrix_);
  KINSetJacFn(memory_, jacobian);
  KINSetMaxSetupCalls(memory_, 1);
  KINSetNumMaxIters(memory_, loop_.settings.most_iterations);
  KINSetFuncNormTol(memory_, loop_.settings.tolerance);
  KINSetScaledStepTol(memory_, std::numeric_limits<double>::epsilon());
}

LoopSolver::~LoopSolver() {
  KINFree(&memory_);
  SUNLinSolFree(solver_);
  SUNMatDestroy(matrix_);
  for (N_Vector vector : {v_, f_, scale_}) N_VDestroy(vector);
  SUNContext_Free(&context_);
}

/// f = g(v) - v.
void LoopSolver::evaluate(const double* v, double* f) {
  for (int k = 0; k < size_; ++k) image_[loop_.cuts[k]] = v[k];
  program_.run(image_, loop_.first, loop_.last);
  for (int k = 0; k < size_; ++k) f[k] = image_[loop_.cuts[k]] - v[k];
}

/// What is not finite is told to KINSOL as a failure that a shorter step may mend.
int LoopSolver::residual(N_Vector v, N_Vector f, void* self) {
  LoopSolver& solver = *static_cast<LoopSolver*>(self);
  double* const values = N_VGetArrayPointer(f);
  solver.evaluate(N_VGetArrayPointer(v), values);
  return std::all_of(values, values + solver.size_, [](double value) { return std::isfinite(value); }) ? 0
                                                                                                       : 1;
}

/// Forward differences, column by column.
int LoopSolver::jacobian(  // NOLINT(readability-function-size): KINSOL calls it
    N_Vector at, N_Vector f, SUNMatrix j, void* self, N_Vector, N_Vector) {
  LoopSolver& solver = *static_cast<LoopSolver*>(self);
  double *const v = N_VGetArrayPointer(at), *const f0 = N_VGetArrayPointer(f);
  for (int c = 0; c < solver.size_; ++c) {
    const double before = v[c];
    const double step = std::sqrt(std::numeric_limits<double>::epsilon()) * std::max(std::abs(before), 1.0);
    v[c] = before + step;
    double* const column = SUNDenseMatrix_Column(j, c);
    solver.evaluate(v, column);
    for (int r = 0; r < solver.size_; ++r) column[r] = (column[r] - f0[r]) / (v[c] - before);
    v[c] = before;
  }
  return 0;
}

void LoopSolver::take_message(int, const char*, const char*, char* message, void* self) {
  static_cast<LoopSolver*>(self)->message_ = message;
}

/// Relative to the signals, or absolute where they are below 1.
double LoopSolver::largest(const double* f) const {
  const double* const scale = N_VGetArrayPointer(scale_);
  double most = 0.0;
  for (int k = 0; k < size_; ++k)
    most = std::max(most, std::isfinite(f[k]) ? scale[k] * std::abs(f[k]) : HUGE_VAL);
  return most;
}

void LoopSolver::refuse(double residual) const {
  if (const std::string source = program_.not_finite(image_, loop_.first); !source.empty())
    throw Error(ErrorCode::numerical, fmt::format("{} at t = {} s", source, image_[program_.time]));
  throw Error(
      ErrorCode::numerical,
      fmt::format(
          "the algebraic loop through the blocks {} has no solution near the last one at t = {} s: its "
          "residual is {} after up to {} iterations; allowed is {}, and a guess in the table [loops] to "
          "begin at{}",
          loop_.blocks, image_[program_.time], residual, loop_.settings.most_iterations,
          loop_.settings.tolerance, message_.empty() ? "" : " (KINSOL: " + message_ + ")"));
}

void LoopSolver::solve(double* image) {
  image_ = image;
  message_.clear();
  double *const v = N_VGetArrayPointer(v_), *const f = N_VGetArrayPointer(f_);
  double* const scale = N_VGetArrayPointer(scale_);
  for (int k = 0; k < size_; ++k) v[k] = image[loop_.cuts[k]], scale[k] = 1.0 / std::max(std::abs(v[k]), 1.0);
  evaluate(v, f);
  if (largest(f) <= loop_.settings.tolerance) return;
  KINSol(memory_, v_, KIN_LINESEARCH, scale_, scale_);
  for (int k = 0; k < size_; ++k) scale[k] = 1.0 / std::max(std::abs(v[k]), 1.0);
  evaluate(v, f);
  if (!(largest(f) <= loop_.settings.tolerance)) refuse(largest(f));
}

}  // namespace tandem::engine
