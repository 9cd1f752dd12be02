// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// SuperLU: J. W. Demmel, S. C. Eisenstat, J. R. Gilbert, X. S. Li, J. W. H. Liu, SIAM J. Matrix Anal. Appl.
// 20 (1999) 720.
#include <slu_ddefs.h>

#include <algorithm>
#include <new>
#include <vector>

#include "blas_threads.hpp"
#include "thesis_solvers/thesis_solvers.hpp"

namespace tandem::test {
namespace {

using namespace mbs;
using solvers::OneBlasThread;

/// Orders by minimum degree of A + A^T for symmetric matrices, which prefer their diagonal as pivots, else by
/// COLAMD. Order and elimination tree are kept, pivots are chosen anew.
class SuperLu final : public LinearSolver {
 public:
  explicit SuperLu(MatrixKind kind) {
    set_default_options(&options_);
    options_.ColPerm = COLAMD;
    if (kind == MatrixKind::unsymmetric) return;
    options_.ColPerm = MMD_AT_PLUS_A;
    options_.SymmetricMode = YES;
    options_.DiagPivotThresh = 1e-3;
  }
  ~SuperLu() override { free_factors(); }
  SuperLu(const SuperLu&) = delete;
  SuperLu& operator=(const SuperLu&) = delete;

  void analyze(const Pattern& pattern) override {
    free_factors();
    pattern_ = pattern;
    n_ = pattern.columns();
    for (auto* list : {&column_order_, &row_order_, &tree_}) list->assign(static_cast<std::size_t>(n_), 0);
    std::vector<double> none(static_cast<std::size_t>(pattern.size()));
    SuperMatrix a = matrix(none.data());
    get_perm_c(options_.ColPerm, &a, column_order_.data());
    Destroy_SuperMatrix_Store(&a);
    options_.Fact = DOFACT;
  }

  Layout layout() const override { return pattern_.entries(); }

  int factorize(double* values) override {
    const OneBlasThread one;
    free_factors();
    SuperMatrix a = matrix(values), ordered{};
    sp_preorder(&options_, &a, column_order_.data(), tree_.data(), &ordered);
    SuperLUStat_t statistics;
    StatInit(&statistics);
    int info = 0;
    dgstrf(&options_, &ordered, sp_ienv(2), sp_ienv(1), tree_.data(), nullptr, 0, column_order_.data(),
           row_order_.data(), &lower_, &upper_, &memory_, &statistics, &info);
    StatFree(&statistics);
    Destroy_CompCol_Permuted(&ordered);
    Destroy_SuperMatrix_Store(&a);
    if (info > n_) throw std::bad_alloc();
    factorized_ = true;
    options_.Fact = SamePattern;
    const auto at = std::find(column_order_.begin(), column_order_.end(), info - 1);
    return info == 0 ? -1 : static_cast<int>(at - column_order_.begin());
  }

  void solve(double* b) override {
    const OneBlasThread one;
    SuperMatrix right{};
    dCreate_Dense_Matrix(&right, n_, 1, b, n_, SLU_DN, SLU_D, SLU_GE);
    SuperLUStat_t statistics;
    StatInit(&statistics);
    int info = 0;
    dgstrs(NOTRANS, &lower_, &upper_, column_order_.data(), row_order_.data(), &right, &statistics, &info);
    StatFree(&statistics);
    Destroy_SuperMatrix_Store(&right);
  }

 private:
  SuperMatrix matrix(double* values) {
    SuperMatrix a{};
    dCreate_CompCol_Matrix(&a, n_, n_, pattern_.size(), values, const_cast<int*>(pattern_.indices().data()),
                           const_cast<int*>(pattern_.starts().data()), SLU_NC, SLU_D, SLU_GE);
    return a;
  }
  void free_factors() {
    if (!factorized_) return;
    Destroy_SuperNode_Matrix(&lower_);
    Destroy_CompCol_Matrix(&upper_);
    factorized_ = false;
  }

  Pattern pattern_;
  int n_ = 0;
  bool factorized_ = false;
  superlu_options_t options_{};
  GlobalLU_t memory_{};
  SuperMatrix lower_{}, upper_{};
  std::vector<int> column_order_, row_order_, tree_;
};

}  // namespace

std::unique_ptr<LinearSolver> superlu(MatrixKind kind) { return std::make_unique<SuperLu>(kind); }

}  // namespace tandem::test
