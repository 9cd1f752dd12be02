// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// MUMPS: P. R. Amestoy, I. S. Duff, J. Koster, J.-Y. L'Excellent, SIAM J. Matrix Anal. Appl. 23 (2001) 15.
#include <dmumps_c.h>

#include <algorithm>
#include <mutex>
#include <new>
#include <string>
#include <vector>

#include "blas_threads.hpp"
#include "tandem/error.hpp"
#include "thesis_solvers/thesis_solvers.hpp"

namespace tandem::test {
namespace {

using namespace mbs;
using solvers::OneBlasThread;

enum Job { finish = -2, start = -1, analysis = 1, factorization = 2, solution = 3 };

/// The sequential MUMPS shares data between its instances.
std::mutex& mumps_lock() {
  static std::mutex lock;
  return lock;
}

/// The multifrontal solver, with the order that it chooses itself; L D L^T with pivots for a symmetric
/// matrix, without for a positive definite one.
class Mumps final : public LinearSolver {
 public:
  explicit Mumps(MatrixKind kind) {
    mumps_.sym = kind == MatrixKind::positive_definite ? 1 : kind == MatrixKind::symmetric ? 2 : 0;
    mumps_.par = 1;
    mumps_.comm_fortran = -987654;  // MPI_COMM_WORLD, by MUMPS' convention
    run(start);
    for (const int stream : {1, 2, 3, 4}) setting(stream) = stream == 4 ? 0 : -1;  // prints nothing
    setting(24) = 1;                                                               // finds pivots that vanish
  }
  ~Mumps() override { run(finish); }
  Mumps(const Mumps&) = delete;
  Mumps& operator=(const Mumps&) = delete;

  void analyze(const Pattern& pattern) override {
    pattern_ = mumps_.sym == 0 ? pattern : pattern.lower();
    rows_.clear(), columns_.clear();
    for (const auto& [row, column] : pattern_.entries())
      rows_.push_back(row + 1), columns_.push_back(column + 1);
    mumps_.n = pattern_.columns();
    mumps_.nnz = pattern_.size();
    mumps_.irn = rows_.data();
    mumps_.jcn = columns_.data();
    run(analysis);
    if (mumps_.infog[0] < 0) fail("analysis");
  }

  Layout layout() const override { return pattern_.entries(); }

  int factorize(double* values) override {
    constexpr int singular = -10, too_little_memory = -9;
    const OneBlasThread one;
    mumps_.a = values;
    run(factorization);
    while (mumps_.infog[0] == too_little_memory) {
      setting(14) *= 2;  // percent more than was estimated
      run(factorization);
    }
    if (mumps_.infog[27] > 0) return mumps_.pivnul_list[0] - 1;
    if (mumps_.infog[0] == singular) return singular_column(values);
    if (mumps_.infog[0] < 0) fail("factorization");
    return -1;
  }

  void solve(double* b) override {
    const OneBlasThread one;
    mumps_.rhs = b;
    run(solution);
    if (mumps_.infog[0] < 0) fail("solution");
  }

 private:
  int& setting(int k) { return mumps_.icntl[k - 1]; }
  void run(Job job) {
    const std::lock_guard lock(mumps_lock());
    mumps_.job = job;
    dmumps_c(&mumps_);
  }
  /// Without pivots it does not tell which.
  int singular_column(double* values) const {
    Mumps with_pivots(MatrixKind::symmetric);
    with_pivots.analyze(pattern_);
    return std::max(0, with_pivots.factorize(values));
  }
  [[noreturn]] void fail(const char* job) const {
    throw Error(ErrorCode::numerical, std::string("MUMPS: ") + job + " failed with code " +
                                          std::to_string(mumps_.infog[0]) + ", " +
                                          std::to_string(mumps_.infog[1]));
  }

  Pattern pattern_;
  std::vector<int> rows_, columns_;
  DMUMPS_STRUC_C mumps_{};
};

}  // namespace

std::unique_ptr<LinearSolver> mumps(MatrixKind kind) { return std::make_unique<Mumps>(kind); }

}  // namespace tandem::test
