// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// UMFPACK: T. A. Davis, ACM Trans. Math. Softw. 30 (2004) 196.
#include <umfpack.h>

#include <algorithm>
#include <array>
#include <new>
#include <vector>

#include "blas_threads.hpp"
#include "thesis_solvers/thesis_solvers.hpp"

namespace tandem::test {
namespace {

using namespace mbs;
using solvers::OneBlasThread;

/// Orders by AMD for symmetric matrices, else by COLAMD; pivots are chosen anew in each factorization.
class Umfpack final : public LinearSolver {
 public:
  explicit Umfpack(MatrixKind kind) {
    umfpack_di_defaults(control_.data());
    control_[UMFPACK_STRATEGY] =
        kind == MatrixKind::unsymmetric ? UMFPACK_STRATEGY_AUTO : UMFPACK_STRATEGY_SYMMETRIC;
    control_[UMFPACK_IRSTEP] = 0;  // no other solver here refines its solution
  }
  ~Umfpack() override {
    umfpack_di_free_numeric(&numeric_);
    umfpack_di_free_symbolic(&symbolic_);
  }
  Umfpack(const Umfpack&) = delete;
  Umfpack& operator=(const Umfpack&) = delete;

  void analyze(const Pattern& pattern) override {
    umfpack_di_free_symbolic(&symbolic_);
    pattern_ = pattern;
    const int n = pattern_.columns();
    x_.resize(static_cast<std::size_t>(n));
    if (umfpack_di_symbolic(n, n, starts(), rows(), nullptr, &symbolic_, control_.data(), nullptr) !=
        UMFPACK_OK)
      throw std::bad_alloc();
  }

  Layout layout() const override { return pattern_.entries(); }

  int factorize(double* values) override {
    const OneBlasThread one;
    umfpack_di_free_numeric(&numeric_);
    values_ = values;
    const int status =
        umfpack_di_numeric(starts(), rows(), values, symbolic_, &numeric_, control_.data(), nullptr);
    if (status == UMFPACK_WARNING_singular_matrix) return zero_pivot();
    if (status != UMFPACK_OK) throw std::bad_alloc();
    return -1;
  }

  void solve(double* b) override {
    const OneBlasThread one;
    umfpack_di_solve(UMFPACK_A, starts(), rows(), values_, x_.data(), b, numeric_, control_.data(), nullptr);
    std::copy(x_.begin(), x_.end(), b);
  }

 private:
  const int* starts() const { return pattern_.starts().data(); }
  const int* rows() const { return pattern_.indices().data(); }

  int zero_pivot() const {
    std::vector<double> pivots(x_.size());
    std::vector<int> columns(x_.size());
    umfpack_di_get_numeric(nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, columns.data(),
                           pivots.data(), nullptr, nullptr, numeric_);
    const auto zero = std::find_if(pivots.begin(), pivots.end(), [](double d) { return !(d != 0.0); });
    return columns[std::min(zero - pivots.begin(), static_cast<std::ptrdiff_t>(columns.size()) - 1)];
  }

  Pattern pattern_;
  std::array<double, UMFPACK_CONTROL> control_{};
  void *symbolic_ = nullptr, *numeric_ = nullptr;
  const double* values_ = nullptr;
  std::vector<double> x_;
};

}  // namespace

std::unique_ptr<LinearSolver> umfpack(MatrixKind kind) { return std::make_unique<Umfpack>(kind); }

}  // namespace tandem::test
