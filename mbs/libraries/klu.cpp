// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// KLU: T. A. Davis, E. Palamadai Natarajan, ACM Trans. Math. Softw. 37 (2010) 36.
#include <klu.h>

#include <new>

#include "check_memory.hpp"
#include "library_solvers.hpp"

namespace tandem::mbs::solvers {
namespace {

/// Orders by AMD of A + A^T. Factors with the pivots of the last full factorization for as long as the growth
/// of the factors stays near what it was then; else, or if told so always, chooses pivots anew.
class Klu final : public LinearSolver {
 public:
  explicit Klu(bool always_full) : always_full_(always_full) {
    klu_defaults(&common_);
    common_.scale = 0;  // the tangents are scaled alike already, and scaling costs a pass
  }
  ~Klu() override {
    klu_free_numeric(&numeric_, &common_);
    klu_free_symbolic(&symbolic_, &common_);
  }
  Klu(const Klu&) = delete;
  Klu& operator=(const Klu&) = delete;

  void analyze(const Pattern& pattern) override {
    klu_free_numeric(&numeric_, &common_);
    klu_free_symbolic(&symbolic_, &common_);
    pattern_ = pattern;
    pivoted_.clear();
    symbolic_ = klu_analyze(pattern_.columns(), starts(), rows(), &common_);
    if (!symbolic_) throw std::bad_alloc();
  }

  Layout layout() const override { return pattern_.entries(); }

  int factorize(double* a) override {
    if (!always_full_ && numeric_ && klu_refactor(starts(), rows(), a, symbolic_, numeric_, &common_) &&
        !grown(a))
      return -1;
    return choose_pivots(a);
  }

  void solve(double* b) override { klu_solve(symbolic_, numeric_, pattern_.columns(), 1, b, &common_); }

  /// The matrix whose pivots it uses.
  void remember(std::vector<double>& to) const override {
    to.insert(to.end(), pivoted_.begin(), pivoted_.end());
  }
  void recall(std::span<const double> memory) override {
    check_memory(memory.empty() || (!always_full_ && memory.size() == pattern_.indices().size()));
    std::vector<double> matrix(memory.begin(), memory.end());
    pivoted_.clear();
    klu_free_numeric(&numeric_, &common_);
    if (!matrix.empty()) choose_pivots(matrix.data());
  }

 private:
  int choose_pivots(double* a) {
    klu_free_numeric(&numeric_, &common_);
    numeric_ = klu_factor(starts(), rows(), a, symbolic_, &common_);
    if (!numeric_ || common_.status == KLU_SINGULAR) return common_.singular_col;
    if (always_full_) return -1;
    growth_ = growth_of(a);
    pivoted_.assign(a, a + pattern_.indices().size());
    return -1;
  }
  static constexpr double worst = 1e-3;  ///< of the growth after a full factorization

  int* starts() { return const_cast<int*>(pattern_.starts().data()); }
  int* rows() { return const_cast<int*>(pattern_.indices().data()); }
  /// Reciprocal pivot growth: the least over the columns of max|A| / max|U|; small is bad.
  double growth_of(double* a) {
    klu_rgrowth(starts(), rows(), a, symbolic_, numeric_, &common_);
    return common_.rgrowth;
  }
  bool grown(double* a) { return growth_of(a) < worst * growth_; }

  bool always_full_;
  Pattern pattern_;
  klu_common common_{};
  klu_symbolic* symbolic_ = nullptr;
  klu_numeric* numeric_ = nullptr;
  double growth_ = 0.0;
  std::vector<double> pivoted_;  ///< the matrix that pivots were chosen for, unless always
};

}  // namespace

std::unique_ptr<LinearSolver> klu(MatrixKind) { return std::make_unique<Klu>(false); }
std::unique_ptr<LinearSolver> klu_full(MatrixKind) { return std::make_unique<Klu>(true); }

}  // namespace tandem::mbs::solvers
