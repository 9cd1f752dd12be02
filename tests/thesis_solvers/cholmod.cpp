// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// CHOLMOD: Y. Chen, T. A. Davis, W. W. Hager, S. Rajamanickam, ACM Trans. Math. Softw. 35 (2008) 22.
#include <cholmod.h>

#include <algorithm>
#include <new>

#include "blas_threads.hpp"
#include "thesis_solvers/thesis_solvers.hpp"

namespace tandem::test {
namespace {

using namespace mbs;
using solvers::OneBlasThread;

/// L D L^T column by column, or L L^T by supernodes with BLAS. CHOLMOD orders by AMD, and by METIS if AMD
/// leaves much fill.
class Cholmod final : public LinearSolver {
 public:
  explicit Cholmod(int supernodal) {
    cholmod_start(&common_);
    common_.supernodal = supernodal;
    common_.print = 0;  // what it has to say is told by its status
  }
  ~Cholmod() override {
    free_factor();
    cholmod_finish(&common_);
  }
  Cholmod(const Cholmod&) = delete;
  Cholmod& operator=(const Cholmod&) = delete;

  void analyze(const Pattern& pattern) override {
    free_factor();
    pattern_ = pattern.lower();
    matrix_ = {};
    matrix_.nrow = matrix_.ncol = static_cast<std::size_t>(pattern_.columns());
    matrix_.nzmax = static_cast<std::size_t>(pattern_.size());
    matrix_.p = const_cast<int*>(pattern_.starts().data());  // CHOLMOD's interface is not const
    matrix_.i = const_cast<int*>(pattern_.indices().data());
    matrix_.stype = -1;  // the lower triangle
    matrix_.itype = CHOLMOD_INT;
    matrix_.xtype = CHOLMOD_PATTERN;
    matrix_.dtype = CHOLMOD_DOUBLE;
    matrix_.sorted = matrix_.packed = 1;
    factor_ = cholmod_analyze(&matrix_, &common_);
    if (!factor_) throw std::bad_alloc();
    right_ = {};
    right_.nrow = right_.nzmax = right_.d = matrix_.nrow;
    right_.ncol = 1;
    right_.xtype = CHOLMOD_REAL;
    right_.dtype = CHOLMOD_DOUBLE;
  }

  Layout layout() const override { return pattern_.entries(); }

  int factorize(double* values) override {
    const OneBlasThread one;
    matrix_.x = values;
    matrix_.xtype = CHOLMOD_REAL;
    if (!cholmod_factorize(&matrix_, factor_, &common_)) throw std::bad_alloc();
    const bool whole = factor_->minor == factor_->n;
    return whole ? -1 : static_cast<const int*>(factor_->Perm)[factor_->minor];
  }

  void solve(double* b) override {
    const OneBlasThread one;
    right_.x = b;
    if (!cholmod_solve2(CHOLMOD_A, factor_, &right_, nullptr, &solution_, nullptr, &work_, &more_work_,
                        &common_))
      throw std::bad_alloc();
    std::copy_n(static_cast<const double*>(solution_->x), right_.nrow, b);
  }

 private:
  void free_factor() {
    cholmod_free_factor(&factor_, &common_);
    for (cholmod_dense** dense : {&solution_, &work_, &more_work_}) cholmod_free_dense(dense, &common_);
  }

  Pattern pattern_;
  cholmod_common common_{};
  cholmod_sparse matrix_{};
  cholmod_dense right_{};
  cholmod_factor* factor_ = nullptr;
  cholmod_dense *solution_ = nullptr, *work_ = nullptr, *more_work_ = nullptr;
};

}  // namespace

std::unique_ptr<LinearSolver> cholmod(MatrixKind) { return std::make_unique<Cholmod>(CHOLMOD_SIMPLICIAL); }
std::unique_ptr<LinearSolver> cholmod_supernodal(MatrixKind) {
  return std::make_unique<Cholmod>(CHOLMOD_SUPERNODAL);
}

}  // namespace tandem::test
