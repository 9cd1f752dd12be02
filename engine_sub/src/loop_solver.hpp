// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <string>

#include "tandem/engine/program.hpp"

namespace tandem::engine {

/// Solves one algebraic loop: v = g(v), where v are the signals at which it is cut and g what its operations
/// make of them, by KINSOL (A. Hindmarsh et al., ACM Trans. Math. Softw. 31 (2005) 363): Newton's method with
/// line search and a Jacobian by differences at each iteration. It begins at the last solution in the image
/// and keeps nothing else, so results depend on the image alone.
class LoopSolver {
 public:
  LoopSolver(const Program& program, const Loop& loop);
  ~LoopSolver();
  LoopSolver(const LoopSolver&) = delete;
  LoopSolver& operator=(const LoopSolver&) = delete;

  const Loop& loop() const { return loop_; }
  /// Leaves all signals of the loop as they are at its solution. Throws Error(numerical) that names the loop,
  /// the time and the residual where there is none.
  void solve(double* image);

 private:
  static int residual(N_Vector v, N_Vector f, void* self);
  static int jacobian(N_Vector v, N_Vector f, SUNMatrix j, void* self, N_Vector, N_Vector);
  static void take_message(int code, const char* module, const char* function, char* message, void* self);

  void create();
  void evaluate(const double* v, double* f);
  double largest(const double* f) const;
  [[noreturn]] void refuse(double residual) const;

  const Program& program_;
  const Loop& loop_;
  int size_;
  SUNContext context_ = nullptr;
  N_Vector v_ = nullptr, f_ = nullptr, scale_ = nullptr;
  SUNMatrix matrix_ = nullptr;
  SUNLinearSolver solver_ = nullptr;
  void* memory_ = nullptr;
  double* image_ = nullptr;  ///< of the last solve()
  std::string message_;
};

}  // namespace tandem::engine
