// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tandem/mbs/sparse/pattern.hpp"

namespace tandem::mbs {

/// What is known of a square matrix. A solver may be used for a matrix of a better kind than its own.
enum class MatrixKind { positive_definite, symmetric, unsymmetric };

/// By position of an array of values the (row, column) of the matrix that stands there; (-1, -1): none, and
/// the value is zero.
using Layout = std::vector<std::pair<int, int>>;

/// Solves A x = b again and again for matrices of one pattern: analyze() once, then factorize() for new
/// values, then solve() as often as wanted. One object is used by one thread at a time.
class LinearSolver {
 public:
  virtual ~LinearSolver() = default;

  /// Prepares for a square pattern with all diagonal entries, both triangles of a symmetric matrix.
  virtual void analyze(const Pattern& pattern) = 0;
  /// Which values factorize() takes, and in which order: those of the pattern in its own order, or whatever
  /// the solver factorizes in place. Of a symmetric matrix an entry may be named by either triangle. Entries
  /// that the pattern has not are zero.
  virtual Layout layout() const = 0;
  /// values: by position of the layout. They may be overwritten, and stay the solver's until the last solve()
  /// that needs them. Returns -1, or the column at which the matrix is singular (or not positive definite,
  /// for a solver that needs it) to working precision.
  virtual int factorize(double* values) = 0;
  /// True: after factorize() the factors stand in those values, and all that solve() needs.
  virtual bool in_place() const { return false; }
  /// b becomes A^-1 b. Precondition: the last factorize() returned -1.
  virtual void solve(double* b) = 0;
  /// Appends what it goes by besides the matrix that it factorizes (one before, whose pivots it uses); and
  /// back: then it factorizes with the same bits. Error(invalid_argument) for that of another.
  virtual void remember(std::vector<double>& /*to*/) const {}
  virtual void recall(std::span<const double> memory);
};

using MakeSolver = std::unique_ptr<LinearSolver>(MatrixKind kind);
/// Adds a solver of one's own to those that make_solver() knows, for matrices of kind `worst` and better.
/// Precondition: no thread makes one meanwhile. Throws Error for a name that is there.
void add_solver(const std::string& name, MatrixKind worst, MakeSolver* make);

/// Names of the solvers for matrices of this kind that this build has.
std::vector<std::string> solver_names(MatrixKind kind);

/// Throws Error for a name that is not there or not for this kind, with those that are.
std::unique_ptr<LinearSolver> make_solver(const std::string& name, MatrixKind kind);

}  // namespace tandem::mbs
