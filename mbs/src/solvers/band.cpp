// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <vector>

#include "band_factors.hpp"
#include "order.hpp"
#include "solvers.hpp"

namespace tandem::mbs::solvers {
namespace {

/// Our own solver for chains: a band matrix after an ordering that makes the band narrow (A. George, J. Liu,
/// Computer Solution of Large Sparse Positive Definite Systems, 1981, ch. 4).
class Band final : public LinearSolver {
 public:
  void analyze(const Pattern& pattern) override {
    const int columns = pattern.columns();
    const auto place = narrow_order(pattern);
    order_.resize(place.size());
    for (int column = 0; column < columns; ++column) order_[place[column]] = column;
    natural_ = std::is_sorted(order_.begin(), order_.end());
    const int width = std::max(1, band_width(pattern, place));
    factors_ = width <= 8 ? narrow_band(columns, width) : wide_band(columns, width);
    x_.resize(place.size());
  }

  Layout layout() const override {
    Layout all = factors_->layout();
    for (auto& [row, column] : all)
      if (row >= 0) row = order_[row], column = order_[column];
    return all;
  }

  int factorize(double* values) override {
    values_ = values;
    const int bad = factors_->factorize(values);
    return bad < 0 ? -1 : order_[bad];
  }

  bool in_place() const override { return true; }

  void solve(double* b) override {
    if (natural_) return factors_->solve(values_, b);
    const auto columns = order_.size();
    for (std::size_t k = 0; k < columns; ++k) x_[k] = b[order_[k]];
    factors_->solve(values_, x_.data());
    for (std::size_t k = 0; k < columns; ++k) b[order_[k]] = x_[k];
  }

 private:
  std::vector<int> order_;  ///< by place in the band the column
  bool natural_ = true;
  std::unique_ptr<BandFactors> factors_;
  const double* values_ = nullptr;  ///< where the factors stand
  std::vector<double> x_;
};

}  // namespace

std::unique_ptr<LinearSolver> band(MatrixKind) { return std::make_unique<Band>(); }

}  // namespace tandem::mbs::solvers
