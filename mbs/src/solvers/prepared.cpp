// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "band_factors.hpp"
#include "elimination.hpp"
#include "order.hpp"
#include "solvers.hpp"

namespace tandem::mbs::solvers {
namespace {

constexpr int long_run = 12;  ///< rows from which on a loop without a list of places pays
constexpr int widest = 4;     ///< columns of a supernode; four pivots at once keep the registers full

/// A supernode in the storage: its columns one after the other, each from its diagonal entry down.
struct Block {
  int first, columns, rows;  ///< rows: those of its columns and those below
  std::int64_t start;
  std::int32_t below;             ///< its places below begin there in a list of all
  std::int32_t updates, updated;  ///< its part of all updates

  /// Where row 0 of column k would stand.
  std::int64_t column(int k) const { return start + k * std::int64_t{rows} - k * (k + 1) / 2; }
};

/// Rows `from` to `to` of a block are columns of another: there its products go.
struct Update {
  int from, to, other;
  std::int32_t index;  ///< in a list: of row `from` and those after it the row in the other block
  bool together;       ///< these follow each other without a gap
};

/// L D L^T of a positive definite matrix with everything but the values prepared: an order with little fill,
/// dense blocks, and for the products of each block where they go. The layout is the storage of L; behind it
/// stands the diagonal once more, which stays.
class Prepared final : public LinearSolver {
 public:
  void analyze(const Pattern& pattern) override {
    elimination_ = eliminate(pattern, minimum_degree_order(pattern), widest);
    if (const auto order = dissection_order(pattern); !order.empty())
      if (Elimination other = eliminate(pattern, order, widest); operations(other) < operations(elimination_))
        elimination_ = std::move(other);
    x_.resize(elimination_.order.size());
    place_blocks();
    place_updates();
  }

  Layout layout() const override {
    const auto& order = elimination_.order;
    Layout all;
    for (const Block& b : blocks_) {
      const auto column_of = [&](int row) {
        return order[row < b.columns ? b.first + row : below_[b.below + row - b.columns]];
      };
      for (int k = 0; k < b.columns; ++k)
        for (int row = k; row < b.rows; ++row) all.emplace_back(column_of(row), order[b.first + k]);
    }
    for (const int column : order) all.emplace_back(column, column);
    return all;
  }

  int factorize(double* values) override {
    values_ = values;
    int bad = -1;
    for (const Block& block : blocks_) {
      with_width(block, [&](auto width) { bad = eliminate_block<width>(block); });
      if (bad >= 0) return elimination_.order[bad];
    }
    return -1;
  }

  bool in_place() const override { return true; }

  void solve(double* b) override {
    const auto& order = elimination_.order;
    for (std::size_t k = 0; k < order.size(); ++k) x_[k] = b[order[k]];
    for (const Block& block : blocks_) with_width(block, [&](auto width) { forward<width>(block); });
    for (auto block = blocks_.rbegin(); block != blocks_.rend(); ++block)
      with_width(*block, [&](auto width) { backward<width>(*block); });
    for (std::size_t k = 0; k < order.size(); ++k) b[order[k]] = x_[k];
  }

 private:
  template <class Run>
  static void with_width(const Block& block, Run&& run) {
    switch (block.columns) {
      case 1:
        return run(std::integral_constant<int, 1>());
      case 2:
        return run(std::integral_constant<int, 2>());
      case 3:
        return run(std::integral_constant<int, 3>());
      default:
        return run(std::integral_constant<int, 4>());
    }
  }

  void place_blocks() {
    blocks_.clear(), below_.clear();
    size_ = 0;
    for (const Supernode& s : elimination_.supernodes) {
      const int rows = s.columns + static_cast<int>(s.rows.size());
      blocks_.push_back({s.first, s.columns, rows, size_, static_cast<std::int32_t>(below_.size()), 0, 0});
      below_.insert(below_.end(), s.rows.begin(), s.rows.end());
      size_ += s.columns * rows - s.columns * (s.columns - 1) / 2;
    }
  }

  void place_updates() {
    updates_.clear(), targets_.clear();
    std::vector<int> block_of;
    for (int k = 0; k < static_cast<int>(blocks_.size()); ++k)
      block_of.insert(block_of.end(), static_cast<std::size_t>(blocks_[k].columns), k);
    for (Block& block : blocks_) {
      block.updates = static_cast<std::int32_t>(updates_.size());
      for (int row = block.columns; row < block.rows;) {
        place_update(block, row, block_of[place(block, row)]);
        row = updates_.back().to;
      }
      block.updated = static_cast<std::int32_t>(updates_.size());
    }
  }

  int place(const Block& block, int row) const { return below_[block.below + row - block.columns]; }

  void place_update(const Block& block, int from, int other) {
    const Block& to = blocks_[other];
    Update update{from, from, other, static_cast<std::int32_t>(targets_.size()), true};
    int target = 0;
    for (int row = from; row < block.rows; ++row) {
      const int at = place(block, row);
      if (at < to.first + to.columns)
        target = at - to.first, update.to = row + 1;
      else
        for (target = std::max(target, to.columns); place(to, target) != at;) ++target;
      targets_.push_back(target);
      update.together = update.together && target - targets_[update.index] == row - from;
    }
    updates_.push_back(update);
  }

  /// [k][r] is row r of the block in its column k.
  template <int B>
  std::array<double*, B> columns(const Block& block) const {
    std::array<double*, B> column;
    for (int k = 0; k < B; ++k) column[k] = values_ + block.column(k);
    return column;
  }

  /// -1, or the place whose pivot is not positive.
  template <int B>
  int eliminate_block(const Block& block) {
    const auto u = columns<B>(block);
    const double* const diagonal = values_ + size_ + block.first;
    std::array<double, B> inverse;
    for (int k = 0; k < B; ++k) {
      if (!(u[k][k] > pivot_floor * diagonal[k])) return block.first + k;
      inverse[k] = 1.0 / u[k][k];
      for (int c = k + 1; c < B; ++c)
        for (int r = c; r < block.rows; ++r) u[c][r] -= u[k][c] * u[k][r] * inverse[k];
    }
    for (int i = block.updates; i < block.updated; ++i) update<B>(updates_[i], u, inverse, block.rows);
    for (int k = 0; k < B; ++k) {
      u[k][k] = inverse[k];
      for (int r = k + 1; r < block.rows; ++r) u[k][r] *= inverse[k];
    }
    return -1;
  }

  template <int B>
  void update(const Update& to, const std::array<double*, B>& u, const std::array<double, B>& inverse,
              int rows) {
    const Block& other = blocks_[to.other];
    const std::int32_t* const targets = targets_.data() + to.index;
    for (int c = to.from; c < to.to; ++c) {
      double* const target = values_ + other.column(targets[c - to.from]);
      std::array<double, B> m;
      for (int k = 0; k < B; ++k) m[k] = u[k][c] * inverse[k];
      const auto subtract = [&](auto&& place) {
        for (int r = c; r < rows; ++r) {
          double sum = m[0] * u[0][r];
          for (int k = 1; k < B; ++k) sum += m[k] * u[k][r];
          target[place(r)] -= sum;
        }
      };
      if (to.together && rows - c >= long_run) {
        const int shift = targets[0] - to.from;
        subtract([=](int r) { return r + shift; });
      } else {
        subtract([&](int r) { return targets[r - to.from]; });
      }
    }
  }

  template <int B>
  void forward(const Block& block) {
    const auto l = columns<B>(block);
    double* const x = x_.data() + block.first;
    const int* const below = below_.data() + block.below;
    std::array<double, B> y;
    for (int k = 0; k < B; ++k) {
      y[k] = x[k];
      for (int p = 0; p < k; ++p) y[k] -= l[p][k] * y[p];
      x[k] = y[k];
    }
    for (int r = B; r < block.rows; ++r) {
      double sum = l[0][r] * y[0];
      for (int k = 1; k < B; ++k) sum += l[k][r] * y[k];
      x_[below[r - B]] -= sum;
    }
  }

  template <int B>
  void backward(const Block& block) {
    const auto l = columns<B>(block);
    double* const x = x_.data() + block.first;
    const int* const below = below_.data() + block.below;
    std::array<double, B> y;
    for (int k = 0; k < B; ++k) y[k] = x[k] * l[k][k];
    for (int r = B; r < block.rows; ++r)
      for (int k = 0; k < B; ++k) y[k] -= l[k][r] * x_[below[r - B]];
    for (int k = B - 1; k >= 0; --k) {
      for (int p = k + 1; p < B; ++p) y[k] -= l[k][p] * y[p];
      x[k] = y[k];
    }
  }

  Elimination elimination_;
  std::vector<Block> blocks_;
  std::vector<Update> updates_;
  std::vector<std::int32_t> below_, targets_;
  std::int64_t size_ = 0;  ///< of L
  double* values_ = nullptr;
  std::vector<double> x_;
};

}  // namespace

std::unique_ptr<LinearSolver> prepared(MatrixKind) { return std::make_unique<Prepared>(); }

}  // namespace tandem::mbs::solvers
